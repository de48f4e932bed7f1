// The lessons as the picture tests draw them: a new lesson adds its line.
#pragma once

#include "lessons/01_ad_hoc_phong/ad_hoc_phong.hpp"
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
         })},
    };
}

}  // namespace glint
