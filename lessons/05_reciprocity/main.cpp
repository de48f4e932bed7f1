#include "lessons/05_reciprocity/reciprocity.hpp"
#include "framework/app/lesson.hpp"
#include "framework/measure/gonioreflectometer.hpp"
#include "framework/scene/false_colour.hpp"
#include "framework/scene/stages.hpp"

#include <glm/trigonometric.hpp>

namespace {

using namespace glint;

// Two domes of directions, one above the other, seen from so far above that their rims are the
// horizon.
Scene two_domes(const Parameters&) {
    Scene s = stages::sphere_grid({{.name = "classic"}, {.name = "lobe"}}, 1, 16.0F / 27.0F);
    const float distance = 200;
    s.camera = {.eye = {0, 0, distance}, .near = distance - 2, .far = distance + 2};
    s.camera.fov_degrees = glm::degrees(2 * std::atan(2.32F / distance));
    return s;
}

struct Either {
    float n;
    bool classic;

    template <Real T>
    Rgb<T> operator()(const Incidence<T>& g) const {
        return classic ? ClassicPhong{n}(g) : PhongLobe{n}(g);
    }
};

enum class Shows { lamp_fixed, viewer_fixed, difference };

// Each point of a dome is a direction; the surface that is measured lies beneath its middle, facing
// us. The white spot is the direction that stands still.
struct Dome {
    Either brdf;
    glm::vec3 fixed;
    Shows shows;
    float most;  // the BRDF that is drawn as the brightest, 1/sr

    template <class T>
    struct Varyings {
        Vec3<T> direction;
    };
    static Varyings<float> vertex(const Vertex& v) { return {v.normal}; }

    template <Real T, class Noting = Silent>
    Rgb<T> operator()(const Varyings<T>& in, const Noting& note = {}) const {
        const Vec3<T> moving = normalize_or(in.direction, Vec3<T>(T(0.0F)));
        const Vec3<T> N(glm::vec3(0, 0, 1));
        const Incidence<T> g = incidence(N, Vec3<T>(fixed), moving);
        note("f(L,V)", brdf(g).g);
        note("f(V,L)", brdf(swapped(g)).g);
        note("their difference", reciprocity_error(brdf, g).g);
        const T value = shows == Shows::lamp_fixed     ? brdf(g).g
                        : shows == Shows::viewer_fixed ? brdf(swapped(g)).g
                                                       : abs(reciprocity_error(brdf, g).g);
        const T x = value / most;
        const Rgb<T> over(clamp((x - T(1.0F)) * 3.0F, T(0.0F), T(1.0F)));
        const Rgb<T> colour = mix(false_colour(min(x, T(1.0F))), false_colour(T(2.0F)), over);
        const T away = length(moving - Vec3<T>(fixed));  // keeps digits that L.V near 1 has lost
        const Rgb<T> spot(clamp((T(0.0586F) - away) * 60.0F, T(0.0F), T(1.0F)));
        return mix(colour, Rgb<T>(T(1.0F)), spot);
    }
};

auto make(const Scene&, const Material& m, const Parameters& p) {
    const float theta = glm::radians(p["theta"]);
    const glm::vec3 fixed(-0.8F * std::sin(theta), 0.6F * std::sin(theta), std::cos(theta));
    return Dome{
        {p["n"], m.name == "classic"}, fixed, Shows{static_cast<int>(p["shows"])}, p["most"]};
}

}  // namespace

int main(int argc, char** argv) {
    return run_lesson(
        argc, argv,
        {.name = "05_reciprocity",
         .title = "Lesson 5: what changes when light and viewer change places",
         .parameters = {{"shows", 2, 0, 2, "0: f(L,V), 1: f(V,L), 2: |f(L,V) - f(V,L)|", true},
                        {"theta", 45, 0, 89, "angle of the direction that is fixed, degrees"},
                        {"n", 3, 0, 1000, "Phong exponent"},
                        {"most", 1.5F, 0.01F, 1000,
                         "the BRDF that is drawn as the brightest, 1/sr"}},
         .panels = {{{"shows", 0}}, {{"shows", 1}}, {{"shows", 2}}},
         .stage = two_domes,
         .shaders = shade_each_material(make)});
}
