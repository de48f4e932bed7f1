#include "lessons/04_rendering_equation/rendering_equation.hpp"
#include "lessons/04_rendering_equation/sky.hpp"
#include "framework/app/lesson.hpp"
#include "framework/scene/false_colour.hpp"
#include "framework/geometry/shapes.hpp"

#include <glm/gtc/matrix_transform.hpp>

namespace {

using namespace glint;

// Three things of the same matt grey, one above the other.
Scene three_views(const Parameters&) {
    Scene s;
    s.materials.clear();
    for (const char* name : {"sky", "constant", "error"}) {
        s.materials.push_back({.name = name, .diffuse = Rgb<float>(0.2F)});
    }
    const glm::mat4 stay(1.0F);
    const glm::mat4 upright =
        glm::rotate(glm::translate(stay, glm::vec3(0, 2.35F, 0)), 1.45F, glm::vec3(1, 0.25F, 0));
    append(s.mesh,
           transform(torus_knot({.tube = 0.24F}, 256, 24), glm::scale(upright, glm::vec3(0.66F))),
           0);
    append(s.mesh, sphere(1.0F, 96, 48), 1);
    append(s.mesh, transform(sphere(1.0F, 96, 48), glm::translate(stay, glm::vec3(0, -2.3F, 0))),
           2);
    s.camera = {.eye = {0, 0.05F, 23},
                .target = {0, 0.05F, 0},
                .fov_degrees = 17.5F,
                .near = 18,
                .far = 30};
    s.background = Rgb<float>(0.010F, 0.012F, 0.016F);
    return s;
}

// What is around each of them.
TwoTones sky_of(const Material& m) {
    return m.name == "sky" ? sky_and_ground : TwoTones{Rgb<float>(1.0F), Rgb<float>(1.0F)};
}

// The sum over the lamps beside the integral in closed form.
struct SumAndIntegral {
    Lit<UnnormalisedLambert> sum;
    TwoTones sky;
    bool closed, shows_error;

    template <class T>
    using Varyings = Lit<UnnormalisedLambert>::Varyings<T>;
    static Varyings<float> vertex(const Vertex& v) { return {v.position, v.normal}; }

    template <Real T, class Noting = Silent>
    Rgb<T> operator()(const Varyings<T>& in, const Noting& note = {}) const {
        const Vec3<T> N = normalize_or(in.normal, Vec3<T>(T(0.0F)));
        const Rgb<T> exact = sum.brdf.Cd * sky.irradiance(N);
        const Rgb<T> found = closed ? exact : sum(in);
        const T error = abs(found.g - exact.g) / exact.g;
        note("sum", found);
        note("integral", exact);
        note("error", error);
        const T shown = log2(T(1.0F) + 100.0F * error) / log2(T(101.0F));  // 10 % is half way
        return shows_error ? false_colour(shown) : found;
    }
};

auto make(const Scene& s, const Material& m, const Parameters& p) {
    const auto count = static_cast<int>(p["directions"]);
    const TwoTones sky = sky_of(m);
    Lighting lights = s.lighting;
    if (lights.directional.empty() && lights.point.empty()) {
        const float d_omega = 4 * std::numbers::pi_v<float> / p["directions"];
        for (const glm::vec3& L : sphere_directions(count)) {
            lights.directional.push_back(lamp_of(sky, L, d_omega));
        }
    }
    return SumAndIntegral{{{m.diffuse}, lights, s.camera.eye}, sky, count == 0, m.name == "error"};
}

}  // namespace

int main(int argc, char** argv) {
    return run_lesson(
        argc, argv,
        {.name = "04_rendering_equation",
         .title = "Lesson 4: the sum over all directions, and its integral",
         .parameters = {{"directions", 1024, 0, 16384, "lamps all round; 0: the integral", true}},
         .panels = {{{"directions", 4}},
                    {{"directions", 16}},
                    {{"directions", 64}},
                    {{"directions", 1024}},
                    {{"directions", 0}}},
         .stage = three_views,
         .shaders = shade_each_material(make)});
}
