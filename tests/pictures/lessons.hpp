// Lessons' shaders to draw many pictures with, on a scene of many materials.
#pragma once

#include "lessons/01_ad_hoc_phong/ad_hoc_phong.hpp"
#include "lessons/04_rendering_equation/rendering_equation.hpp"
#include "lessons/09_normalised_phong/normalised_phong.hpp"
#include "framework/app/lesson.hpp"
#include "framework/scene/stages.hpp"

#include <functional>
#include <string>
#include <vector>

namespace glint {

struct LessonPicture {
    std::string name;
    Scene (*stage)();
    std::function<ShaderSet(const Scene&, const Parameters&)> shaders;
    double tolerance;  // of a colour: the error of V.R grows with n, and with the lobe's height
    Parameters parameters{};
};

inline std::vector<LessonPicture> all_lessons() {
    using S = Scene;
    using M = Material;
    using P = Parameters;
    return {
        {"01_ad_hoc_phong", stages::still_life,
         shade_each_material([](const S& s, const M& m, const P&) {
             return AdHocPhong{m, s.lighting, s.camera.eye};
         }),
         1.2e-5},
        {"09_normalised_phong", stages::still_life,
         shade_each_material([](const S& s, const M& m, const P&) {
             return Lit<NormalisedPhong>{
                 {m.diffuse, m.specular, m.exponent}, s.lighting, s.camera.eye};
         }),
         2e-4},
    };
}

}  // namespace glint
