// Draws meshes for the tests of the rasterizers.
#pragma once

#include "framework/raster/renderer.hpp"
#include "framework/math/dispatch.hpp"

#include <span>
#include <string>
#include <vector>

namespace glint {

struct Drawn {
    SrgbImage srgb;
    LinearImage linear;
    Image<float> depth;
    Image<std::int32_t> triangle;
    Statistics statistics;
};

inline Drawn draw(const Mesh& mesh, const View& view, std::span<const Shader> shaders,
                  const Settings& settings, const Rgb<float>& background = Rgb<float>(0.0F)) {
    Drawn d;
    Renderer renderer(settings);
    d.statistics = renderer.render(mesh, view, shaders,
                                   {.srgb = &d.srgb,
                                    .linear = &d.linear,
                                    .depth = &d.depth,
                                    .triangle = &d.triangle,
                                    .background = background});
    return d;
}

inline Drawn draw(const Mesh& mesh, const View& view, const Shader& shader,
                  const Settings& settings, const Rgb<float>& background = Rgb<float>(0.0F)) {
    return draw(mesh, view, std::span(&shader, 1), settings, background);
}

inline std::vector<int> all_lanes() {
    std::vector<int> lanes;
    for (const int n : {1, 4, 8, 16}) {
        if (has_lanes(n)) {
            lanes.push_back(n);
        }
    }
    return lanes;
}

// The settings for scanline and for the tiles in every width of lanes, otherwise as given.
inline std::vector<Settings> both_rasterizers(Settings settings = {}) {
    settings.rasterizer = Rasterizer::scanline;
    std::vector<Settings> all{settings};
    settings.rasterizer = Rasterizer::tiles;
    for (const int lanes : all_lanes()) {
        settings.lanes = lanes;
        all.push_back(settings);
    }
    return all;
}

inline std::string words(const Settings& s) {
    const std::string lanes = std::to_string(s.lanes) + " lanes, ";
    const std::string threads = std::to_string(s.threads) + " threads, ";
    return (s.rasterizer == Rasterizer::scanline ? "scanline, " : "tiles, " + lanes + threads) +
           std::to_string(s.samples) + " samples" + (s.sample_shading ? ", sample shading" : "") +
           (s.cull == Cull::back ? ", culling" : "");
}

// A view where x and y of the world are pixels of the window and z is depth.
inline View window_view(int width, int height) {
    glm::mat4 clip_from_window(1.0F);
    clip_from_window[0][0] = 2.0F / static_cast<float>(width);
    clip_from_window[1][1] = -2.0F / static_cast<float>(height);
    clip_from_window[3] = {-1.0F, 1.0F, 0.0F, 1.0F};
    return {clip_from_window, width, height};
}

// ---- shaders that show what was interpolated ----

struct ShowPosition {
    template <class T>
    struct Varyings {
        Vec3<T> position;
    };
    static Varyings<float> vertex(const Vertex& v) { return {v.position}; }
    template <Real T>
    Rgb<T> operator()(const Varyings<T>& in) const {
        return in.position;
    }
};
inline constexpr ShowPosition show_position;

struct ShowUv {  // and 1 in blue
    template <class T>
    struct Varyings {
        Vec2<T> uv;
    };
    static Varyings<float> vertex(const Vertex& v) { return {v.uv}; }
    template <Real T>
    Rgb<T> operator()(const Varyings<T>& in) const {
        return {in.uv.x, in.uv.y, T(1.0F)};
    }
};
inline constexpr ShowUv show_uv;

struct OneColour {
    Rgb<float> colour{1.0F};
    template <class T>
    struct Varyings {
        T unused;
    };
    static Varyings<float> vertex(const Vertex&) { return {0.0F}; }
    template <Real T>
    Rgb<T> operator()(const Varyings<T>&) const {
        return Rgb<T>(colour);
    }
};

}  // namespace glint
