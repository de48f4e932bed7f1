// Pictures of scenes, drawn by the rasterizers as a lesson's program does, and what they should be.
#pragma once

#include "framework/app/lesson.hpp"
#include "framework/raster/renderer.hpp"
#include "docs/charts/harness.hpp"

namespace glint::charts {

struct Stage {
    Scene scene;
    ShaderSet shading;
    View view;
};

// Each material shaded by what make(scene, material) returns.
template <class Make>
Stage stage_of(Scene scene, int width, int height, Make make) {
    const auto with_parameters = [make](const Scene& s, const Material& m, const Parameters&) {
        return make(s, m);
    };
    Stage stage{std::move(scene), {}, {}};
    stage.shading = shade_each_material(with_parameters)(stage.scene, Parameters());
    const float aspect = static_cast<float>(width) / static_cast<float>(height);
    stage.view = {clip_from_world(stage.scene.camera, aspect), width, height};
    return stage;
}

// 255 times the sRGB curve of each colour, not rounded.
using Codes = Image<glm::dvec3>;

Codes draw_codes(const Stage& stage, const Settings& settings);

// The mean of 16 x 16 samples a pixel, each of them shaded.
Codes draw_256_samples(const Stage& stage);

// Of all colours, a pixel after the other.
Errors difference(const Codes& picture, const Codes& reference);

// Draws codes to the screen, over and over; a task is a pixel.
Contender frame_contender(const std::string& method, const std::shared_ptr<const Stage>& stage,
                          const Settings& settings, std::vector<Judgement> judgements);

}  // namespace glint::charts
