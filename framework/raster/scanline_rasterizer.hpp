// A frame of the scanline rasterizer.
#pragma once

#include "framework/raster/interpolate.hpp"
#include "framework/raster/pipeline.hpp"
#include "framework/raster/samples.hpp"
#include "framework/raster/shader.hpp"

#include <glm/vec2.hpp>

#include <span>
#include <vector>

namespace glint {

class ScanlineRasterizer {
  public:
    explicit ScanlineRasterizer(const Settings& settings);

    Statistics render(const Mesh& mesh, const View& view, std::span<const Shader> shaders,
                      const Target& target);

  private:
    void find_visible(const View& view);
    void draw(std::int32_t index, std::size_t sample, const View& view);
    void shade_row(const Mesh& mesh, std::span<const Shader> shaders, const Target& target, int y,
                   Statistics& statistics);
    // at: window position in 1/256 pixel.
    Rgb<float> shade(const Mesh& mesh, std::span<const Shader> shaders, std::int32_t triangle,
                     glm::ivec2 at);
    template <class T>
    Rgb<float> shade_as(const Shader& shader, const ScreenTriangle& triangle, glm::ivec2 at) const;
    void write_row(const Target& target, int y) const;

    Settings settings_;
    std::span<const SampleOffset> offsets_;
    std::vector<ScreenTriangle> triangles_;
    std::vector<Image<float>> depth_;         // by sample
    std::vector<Image<std::int32_t>> owner_;  // by sample; place in triangles_
    std::vector<Rgb<float>> row_;
    std::vector<std::uint8_t> won_a_sample_;

    // What was interpolated last.
    std::int32_t corners_of_ = no_triangle;
    CornerVaryings corners_{};
    Edges edges_{};
    EyeRays rays_{};
};

}  // namespace glint
