#include "lessons/01_ad_hoc_phong/ad_hoc_phong.hpp"
#include "framework/app/lesson.hpp"
#include "framework/scene/stages.hpp"

int main(int argc, char** argv) {
    using namespace glint;
    return run_lesson(
        argc, argv,
        {.name = "01_ad_hoc_phong",
         .title = "Lesson 1: ambient + Kd (N.L) + Ks (V.R)^n, tweaked by hand",
         .stage = [](const Parameters&) { return stages::still_life(); },
         .shaders = shade_each_material([](const Scene& s, const Material& m, const Parameters&) {
             return AdHocPhong{m, s.lighting, s.camera.eye};
         })});
}
