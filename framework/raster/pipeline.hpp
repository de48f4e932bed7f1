// What flows through the rasterizer, in order:
//
//     Mesh -> VertexBuffer -> ScreenTriangle -> samples won -> Fragment -> colour -> Target
//      (1) transform   (2) assemble, clip, cull   (3) visibility   (4) shading   (5) output
//
// Conventions: clip space as OpenGL's in x and y, depth z/w from 1 (near) to 0 (far, "reversed z"),
// positive w in front of the eye. Window space has its origin top-left, y down, pixel centres at
// (x + 1/2, y + 1/2). Triangles that run counter-clockwise for the viewer are front faces.
#pragma once

#include "framework/image/image.hpp"
#include "framework/math/fixed.hpp"
#include "framework/math/memory.hpp"
#include "framework/math/vec.hpp"

#include <glm/mat4x4.hpp>

#include <cstdint>

namespace glint {

// reference: scanline, but varyings and colours are computed in double, what accuracy is measured
// against.
enum class Rasterizer { tiles, scanline, reference };
enum class Cull { none, back };

// How to draw. None but samples and cull changes which triangle wins a sample, nor its depth.
struct Settings {
    Rasterizer rasterizer = Rasterizer::tiles;
    int lanes = max_lanes;        // 1, 4, 8 or 16, as far as the build has them; scanline has one
    int threads = 1;              // 1..256; scanline uses one
    int samples = 1;              // 1, 2, 4, 8 or 16 a pixel
    bool sample_shading = false;  // shade every sample, not every pixel and triangle
    Cull cull = Cull::none;
};

// Where from: reversed-z clip coordinates of world space, and the size of the window.
struct View {
    glm::mat4 clip_from_world{1.0F};
    int width = 0;   // 1..16384 pixels
    int height = 0;  // 1..16384 pixels
};

inline constexpr std::int32_t no_triangle = -1;

// Where to. Pictures are resized to the view; what is null is not made.
struct Target {
    SrgbImage* srgb = nullptr;
    LinearImage* linear = nullptr;
    Image<float>* depth = nullptr;            // of the sample nearest the centre; 0: nothing there
    Image<std::int32_t>* triangle = nullptr;  // likewise; index in the mesh or no_triangle
    Rgb<float> background{0.0F};
};

struct Statistics {
    double geometry_ms = 0;  // the stages' shares of frame_ms
    double visibility_ms = 0;
    double shading_ms = 0;
    double output_ms = 0;
    double frame_ms = 0;
    std::int64_t triangles_in = 0;
    std::int64_t triangles_not_finite = 0;  // dropped: a vertex is NaN or infinite
    std::int64_t triangles_visible = 0;     // won at least one sample
    std::int64_t fragments_shaded = 0;
    std::int64_t tiles_empty = 0;  // cost one clear; scanline has none
};

// A vertex in window space.
struct ScreenVertex {
    std::int32_t x, y;  // 24.8 fixed point pixels
    float z;            // depth
    float inverse_w;
};

// (1) All vertices of a mesh in window space. Those outside the near plane or the guard band, or
// not finite, have no place there: their x is needs_clipping.
using VertexBuffer = LineVector<ScreenVertex>;
inline constexpr std::int32_t needs_clipping = INT32_MIN;

// (2) A triangle whose vertices all have a place in window space: one of the mesh, or a piece of
// one that was clipped. Then corner i is at barycentric[i] of the mesh's triangle.
struct ScreenTriangle {
    ScreenVertex v[3];
    std::uint32_t source;  // index in the mesh
    bool clipped = false;
    glm::dvec3 barycentric[3]{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
};

}  // namespace glint
