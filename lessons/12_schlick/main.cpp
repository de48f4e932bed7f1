#include "lessons/11_fresnel_conductor/fresnel_conductor.hpp"
#include "lessons/11_fresnel_conductor/metals.hpp"
#include "lessons/12_schlick/hall.hpp"
#include "lessons/12_schlick/schlick.hpp"
#include "framework/app/lesson.hpp"
#include "framework/scene/false_colour.hpp"

namespace {

using namespace glint;

enum Form { exact, by_schlick, by_lazanyi };
constexpr int forms = 3;

constexpr std::array<Metal, 5> surfaces{{
    {"glass", Rgb<float>(1.5F), Rgb<float>(0.0F)},
    metals[0],
    metals[1],
    metals[3],
    metals[4],
}};

// Red, green and blue reflectance of a surface by a form.
struct Reflectance {
    Rgb<float> ior, k;
    Form form;

    template <Real T>
    T in_band(int band, const T& cos_i) const {
        const T n(ior[band]);
        const T absorption(k[band]);
        if (form == exact) {
            return fresnel_conductor(n, absorption, cos_i).unpolarised;
        }
        const T F0 = f0_conductor(n, absorption);
        if (form == by_schlick) {
            return schlick(F0, cos_i);
        }
        const T seventh = fresnel_conductor(n, absorption, T(1.0F) / T(7.0F)).unpolarised;
        return lazanyi(F0, lazanyi_dip(F0, seventh), cos_i);
    }
    template <Real T>
    Rgb<T> operator()(const T& cos_i) const {
        return {in_band(0, cos_i), in_band(1, cos_i), in_band(2, cos_i)};
    }
};

struct Strip {
    Reflectance reflectance;
    bool shows_error;
    float sky, worst;
    glm::vec3 eye;

    template <class T>
    struct Varyings {
        Vec3<T> position;
        Vec3<T> normal;
    };
    static Varyings<float> vertex(const Vertex& v) { return {v.position, v.normal}; }

    template <Real T, class Noting = Silent>
    Rgb<T> operator()(const Varyings<T>& in, const Noting& note = {}) const {
        const T cosine = dot(normalize(in.normal), normalize(eye - in.position));
        const Rgb<T> share = reflectance(cosine);
        const Rgb<T> off = share - Reflectance{reflectance.ior, reflectance.k, exact}(cosine);
        note("cos(theta)", cosine);
        note("reflectance", share);
        note("error", off);
        return shows_error ? false_colour(max(abs(off.r), max(abs(off.g), abs(off.b))) / worst)
                           : sky * share;
    }
};

}  // namespace

int main(int argc, char** argv) {
    return run_lesson(
        argc, argv,
        {.name = "12_schlick",
         .title = "Lesson 12: Schlick's approximation of Fresnel's reflectance, and its error",
         .parameters = {{"worst", 0.18F, 1e-6F, 1, "the error that is drawn as the brightest"},
                        {"sky", 0.7F, 0, 100, "radiance of the sky"}},
         .stage = [](const Parameters&) { return hall(static_cast<int>(surfaces.size()), forms); },
         .shaders = shade_each_material([](const Scene& s, const Material& m, const Parameters& p) {
             const auto place = static_cast<std::size_t>(&m - s.materials.data());
             const Metal& surface = surfaces[place / (2 * forms)];
             const auto form = static_cast<Form>(place / 2 % forms);
             return Strip{{surface.ior, surface.k, form},
                          place % 2 == 1,
                          p["sky"],
                          p["worst"],
                          s.camera.eye};
         })});
}
