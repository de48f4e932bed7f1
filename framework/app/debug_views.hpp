// What a student looks at when something is wrong.
#pragma once

#include "framework/raster/pipeline.hpp"
#include "framework/raster/shader.hpp"

namespace glint {

// World-space normals as colours: (n + 1) / 2 by component.
struct NormalView {
    template <class T>
    struct Varyings {
        Vec3<T> normal;
    };
    static Varyings<float> vertex(const Vertex& v) { return {v.normal}; }
    template <Real T>
    Rgb<T> operator()(const Varyings<T>& in) const {
        return 0.5F * (normalize_or(in.normal, Vec3<T>(T(0.0F))) + Vec3<T>(T(1.0F)));
    }
};

// Near is bright, far dark, from the nearest to the farthest depth that occurs; nothing is black.
SrgbImage depth_picture(const Image<float>& depth);

// Each triangle in a colour of its own.
SrgbImage triangle_picture(const Image<std::int32_t>& triangle);
Image<float> as_floats(const Image<std::int32_t>& triangle);

// How many triangles cover each pixel's centre, hidden ones too.
Image<float> overdraw(const Mesh& mesh, const View& view, Cull cull);
SrgbImage count_picture(const Image<float>& count);

// How many triangles the tile rasterizer looks at in the pixel's tile.
Image<float> triangles_by_tile(const Mesh& mesh, const View& view, const Settings& settings);
SrgbImage tile_picture(const Image<float>& count);

}  // namespace glint
