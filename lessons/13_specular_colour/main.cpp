#include "lessons/10_fresnel_dielectric/polished.hpp"
#include "lessons/12_schlick/schlick.hpp"
#include "lessons/13_specular_colour/specular_colour.hpp"
#include "framework/app/lesson.hpp"
#include "framework/scene/stages.hpp"

namespace {

using namespace glint;

// The table's ten materials, five to a row. Material 2i is the left half of sphere i, 2i + 1 its
// right half.
Scene halves(const Parameters&) {
    const Material paint{.diffuse = {0.02F, 0.06F, 0.10F}};
    Scene s = stages::sphere_grid(std::vector(specular_colours.size(), paint), 5, 16.0F / 9.0F);
    for (std::size_t i = 0; i < s.mesh.triangles.size(); ++i) {
        const glm::uvec3& t = s.mesh.triangles[i];
        const auto& n = s.mesh.normals;
        const bool right = n[t.x].x + n[t.y].x + n[t.z].x > 0;
        s.mesh.materials[i] = static_cast<std::uint16_t>(2 * s.mesh.materials[i] + right);
    }
    s.materials = std::vector(2 * specular_colours.size(), paint);
    s.camera = {.eye = {0, 0, 62}, .fov_degrees = 6, .near = 50, .far = 70};  // seams seem straight
    s.lighting.directional[0].irradiance = Rgb<float>(2.0F);
    s.lighting.ambient = Rgb<float>(0.2F);
    return s;
}

struct Schlick {
    Rgb<float> F0;

    template <Real T>
    Rgb<T> operator()(const T& cos_i) const {
        return schlick(Rgb<T>(F0), cos_i);
    }
};

// The mistake: the table's sRGB column, codes for a screen, taken for shares of light.
Rgb<float> codes_of(const Rgb<float>& F0) {
    Rgb<float> codes;
    for (int band = 0; band < 3; ++band) {
        codes[band] = static_cast<float>(srgb_encode(double{F0[band]}));
    }
    return codes;
}

}  // namespace

int main(int argc, char** argv) {
    return run_lesson(
        argc, argv,
        {.name = "13_specular_colour",
         .title = "Lesson 13: F0 as a colour; right halves: sRGB codes taken for reflectances",
         .parameters = {{"mistake", 0.5F, 0, 1,
                         "0: nowhere, 0.5: on the right halves, 1: everywhere"}},
         .stage = halves,
         .shaders = shade_each_material([](const Scene& s, const Material& m, const Parameters& p) {
             const auto place = static_cast<std::size_t>(&m - s.materials.data());
             const SpecularColour& colour = specular_colours[place / 2];
             const bool mistake = p["mistake"] > (place % 2 == 0 ? 0.5F : 0.0F);
             return Polished<Schlick>{
                 {{diffuse_albedo(m.diffuse, colour.metal)}, s.lighting, s.camera.eye},
                 {mistake ? codes_of(colour.F0) : f0_from_srgb(codes_of(colour.F0))},
                 {.room = 2.2F, .pool = 0.3F, .lamps = 0.25F}};
         })});
}
