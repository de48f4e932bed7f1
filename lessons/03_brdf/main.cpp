#include "lessons/01_ad_hoc_phong/ad_hoc_phong.hpp"
#include "lessons/03_brdf/brdf.hpp"
#include "framework/app/lesson.hpp"
#include "framework/scene/stages.hpp"

namespace {

using namespace glint;

// A lamp behind the things, as a window behind a table: their edges are lit, aslant.
Scene against_the_light(const Parameters& p) {
    Scene s = stages::still_life_upright();
    for (Material& m : s.materials) {
        m.exponent = p["n"];
    }
    s.lighting.directional = {{normalize(glm::vec3(0.62F, 0.4F, -0.8F)), Rgb<float>(1.5F)}};
    return s;
}

ShaderSet shaders(const Scene& scene, const Parameters& p) {
    const auto classic =
        shade_each_material([](const Scene& s, const Material& m, const Parameters&) {
            return AdHocPhong{m, s.lighting, s.camera.eye};
        });
    const auto in_units =
        shade_each_material([](const Scene& s, const Material& m, const Parameters&) {
            return PhongInUnits{{m.diffuse, m.specular, m.exponent}, s.lighting, s.camera.eye};
        });
    return p["units"] > 0 ? in_units(scene, p) : classic(scene, p);
}

}  // namespace

int main(int argc, char** argv) {
    return run_lesson(
        argc, argv,
        {.name = "03_brdf",
         .title = "Lesson 3: reflected radiance per irradiance",
         .parameters = {{"units", 1, 0, 1, "0: lesson 1's form, 1: BRDF times E (N.L)", true},
                        {"n", 4, 0, 1000, "Phong exponent"}},
         .panels = {{{"units", 0}}, {{"units", 1}}},
         .stage = against_the_light,
         .shaders = shaders});
}
