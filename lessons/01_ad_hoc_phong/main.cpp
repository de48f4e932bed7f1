#include "lessons/01_ad_hoc_phong/ad_hoc_phong.hpp"
#include "framework/app/lesson.hpp"
#include "framework/scene/stages.hpp"

namespace {

using namespace glint;

Scene under_lights(const Parameters& p) {
    Scene s = stages::still_life_upright();
    s.lighting = p["lights"] < 2 ? stages::key_and_fill() : stages::three_lamps();
    return s;
}

}  // namespace

int main(int argc, char** argv) {
    return run_lesson(
        argc, argv,
        {.name = "01_ad_hoc_phong",
         .title = "Lesson 1: ambient + Kd (N.L) + Ks (V.R)^n, tweaked by hand",
         .parameters = {{"lights", 1, 1, 2, "1: key and fill light, 2: three lamps", true}},
         .panels = {{{"lights", 1}}, {{"lights", 2}}},
         .stage = under_lights,
         .shaders = shade_each_material([](const Scene& s, const Material& m, const Parameters&) {
             return AdHocPhong{m, s.lighting, s.camera.eye};
         })});
}
