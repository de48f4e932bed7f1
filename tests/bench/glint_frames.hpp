// Glint's side of the bench: a scene drawn with lesson 15's final model, its highlights where they
// add 1/1000 code or more.
#pragma once

#include "lessons/15_engine_integration/lit_from_afar.hpp"
#include "lessons/15_engine_integration/where_it_shows.hpp"
#include "framework/raster/plug.hpp"
#include "framework/raster/renderer.hpp"
#include "tests/bench/scenes.hpp"

namespace glint {

using BenchShader = LitFromAfar;

inline BenchShader bench_shader(const Scene& s) {
    const Material& m = s.materials[0];
    const EnginePhong phong{m.diffuse, m.specular, m.exponent};
    const float from = highlight_from(phong, s.lighting, radiance_of_codes(1e-3F));
    return {{phong, from}, s.lighting};
}

inline View bench_view(const BenchScene& b) {
    const float aspect = static_cast<float>(b.width) / static_cast<float>(b.height);
    return {clip_from_world(b.scene.camera, aspect), b.width, b.height};
}

class GlintFrames {
  public:
    GlintFrames(const BenchScene& bench, const Settings& settings)
        : bench_(bench),
          view_(bench_view(bench)),
          shader_(bench_shader(bench.scene)),
          renderer_(settings) {}

    // Draws the sRGB picture, and the others where asked for.
    Statistics frame(LinearImage* linear = nullptr, Image<std::int32_t>* triangle = nullptr) {
        const Shader plugged[] = {plug(shader_)};
        return renderer_.render(bench_.scene.mesh, view_, plugged,
                                {.srgb = &picture_,
                                 .linear = linear,
                                 .triangle = triangle,
                                 .background = bench_.scene.background});
    }
    const SrgbImage& picture() const { return picture_; }

  private:
    const BenchScene& bench_;
    View view_;
    BenchShader shader_;
    Renderer renderer_;
    SrgbImage picture_;
};

}  // namespace glint
