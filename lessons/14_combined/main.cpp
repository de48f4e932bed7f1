#include "lessons/14_combined/combined.hpp"
#include "lessons/14_combined/instruments.hpp"
#include "framework/app/lesson.hpp"
#include "framework/scene/stages.hpp"

namespace {

using namespace glint;

// Two spheres of white paint under varnish, lit from the side: one for each instrument.
Scene two_instruments(const Parameters&) {
    Material paint{.diffuse = Rgb<float>(1.0F), .exponent = 10.0F};
    Scene s = stages::sphere_grid({paint, paint}, 1, 16.0F / 27.0F);
    s.materials[1].name = "reciprocity";
    s.camera.eye.z *= 0.87F;
    s.lighting.directional = {{normalize(glm::vec3(-0.85F, 0.5F, 0.08F)), Rgb<float>(3.0F)}};
    return s;
}

Combined brdf_of(const Material& m, const Parameters& p) {
    return {m.diffuse, m.specular, m.exponent, Remains{static_cast<int>(p["remains"])}};
}

auto see(const Scene& s, const Material& m, const Parameters& p) {
    return Lit<Combined>{brdf_of(m, p), s.lighting, s.camera.eye};
}

auto measure(const Scene& s, const Material& m, const Parameters& p) {
    const Combined brdf = brdf_of(m, p);
    const bool dark = s.lighting.directional.empty();
    return Instruments<Combined>{brdf, AlbedoCurve(brdf), m.name == "reciprocity",
                                 dark ? glm::vec3(0) : s.lighting.directional[0].direction,
                                 s.camera.eye};
}

ShaderSet shaders(const Scene& s, const Parameters& p) {
    return p["shaded"] > 0 ? shade_each_material(see)(s, p) : shade_each_material(measure)(s, p);
}

}  // namespace

int main(int argc, char** argv) {
    return run_lesson(
        argc, argv,
        {.name = "14_combined",
         .title = "Lesson 14: what is left for the diffuse part, by energy and by reciprocity",
         .parameters = {{"remains", 2, 0, 2, "0: Cd, 1: Cd (1 - F(theta)), 2: Cd (1 - F0)", true},
                        {"shaded", 0, 0, 1, "0: the instruments, 1: what the eye sees", true}},
         .panels = {{{"remains", 0}}, {{"remains", 1}}, {{"remains", 2}}},
         .stage = two_instruments,
         .shaders = shaders});
}
