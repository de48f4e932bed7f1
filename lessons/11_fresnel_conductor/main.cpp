#include "lessons/10_fresnel_dielectric/polished.hpp"
#include "lessons/11_fresnel_conductor/fresnel_conductor.hpp"
#include "lessons/11_fresnel_conductor/metals.hpp"
#include "framework/app/lesson.hpp"
#include "framework/scene/stages.hpp"

namespace {

using namespace glint;

enum Row { exact, approximate, error };  // from the top

constexpr Metal glass{"glass", Rgb<float>(1.5F), Rgb<float>(0.0F)};

// Five metals and glass, in three rows.
constexpr int columns = 6;

Scene spheres(const Parameters&) {
    const Material polished{.diffuse = Rgb<float>(0.0F)};
    Scene s = stages::sphere_grid(std::vector(3 * columns, polished), columns, 16.0F / 9.0F);
    s.lighting = {};
    return s;
}

struct Conductor {
    Rgb<float> ior, k;
    Row row;

    template <Real T>
    Rgb<T> operator()(const T& cos_i) const {
        Rgb<T> share;
        for (int band = 0; band < 3; ++band) {
            const T n(ior[band]);
            share[band] = row == exact
                              ? fresnel_conductor(n, T(k[band]), cos_i).unpolarised
                              : fresnel_conductor_approximate(n, T(k[band]), cos_i).unpolarised;
        }
        return share;
    }
};

// The surface in the studio; in the last row instead the greatest error of the three colours.
struct Shown : Polished<Conductor> {
    float worst;

    template <Real T, class Noting = Silent>
    Rgb<T> operator()(const Varyings<T>& in, const Noting& note = {}) const {
        if (reflectance.row != error) {
            return Polished<Conductor>::operator()(in, note);
        }
        const Vec3<T> N = normalize_or(in.normal, Vec3<T>(T(0.0F)));
        const T cosine = dot(N, normalize(beneath.eye - in.position));
        const Rgb<T> truth = Conductor{reflectance.ior, reflectance.k, exact}(cosine);
        const Rgb<T> off = reflectance(cosine) - truth;
        return Rgb<T>(abs(off.r), abs(off.g), abs(off.b)) / worst;
    }
};

}  // namespace

int main(int argc, char** argv) {
    return run_lesson(
        argc, argv,
        {.name = "11_fresnel_conductor",
         .title =
             "Lesson 11: metals by Fresnel's exact formula, by the approximation, and its error",
         .parameters = {{"worst", 0.05F, 1e-6F, 1, "the error that is drawn as the brightest"}},
         .stage = spheres,
         .shaders = shade_each_material([](const Scene& s, const Material& m, const Parameters& p) {
             const auto place = static_cast<std::size_t>(&m - s.materials.data());
             const std::size_t column = place % columns;
             const Metal& metal = column < metals.size() ? metals[column] : glass;
             return Shown{{{{m.diffuse}, s.lighting, s.camera.eye},
                           {metal.ior, metal.k, static_cast<Row>(place / columns)},
                           {.room = 2.6F, .pool = 0.3F, .lamps = 0.2F}},
                          p["worst"]};
         })});
}
