#include "framework/raster/clip.hpp"

#include "framework/raster/transform.hpp"
#include "framework/geometry/mesh.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace glint {
namespace {

struct Corner {
    glm::dvec4 clip;
    glm::dvec3 barycentric;
    std::int64_t vertex = -1;  // in the vertex buffer; -1: made by clipping
};

// A triangle and one more corner for each of the six planes.
struct Polygon {
    std::array<Corner, 9> corner;
    int count = 0;
    void add(const Corner& c) { corner[static_cast<std::size_t>(count++)] = c; }
};

// Signed distances (up to scale) to the planes of near, the eye and the guard band.
constexpr int plane_count = 6;
double distance(int plane, const glm::dvec4& p, const View& view) {
    const double half_width = 0.5 * view.width;
    const double half_height = 0.5 * view.height;
    switch (plane) {
        case 0:
            return p.w - static_cast<double>(smallest_w);
        case 1:
            return p.w - p.z;
        case 2:
            return (guard_band + half_width) * p.w + half_width * p.x;
        case 3:
            return (guard_band - half_width) * p.w - half_width * p.x;
        case 4:
            return (guard_band + half_height) * p.w - half_height * p.y;
        default:
            return (guard_band - half_height) * p.w + half_height * p.y;
    }
}

// Always from the inside to the outside: the same point whichever triangle asks.
Corner cut(const Corner& inside, double in, const Corner& outside, double out) {
    const double t = in / (in - out);
    return {inside.clip + t * (outside.clip - inside.clip),
            inside.barycentric + t * (outside.barycentric - inside.barycentric)};
}

Polygon clip(const Polygon& polygon, int plane, const View& view) {
    Polygon kept;
    for (int i = 0; i < polygon.count; ++i) {
        const Corner& a = polygon.corner[static_cast<std::size_t>(i)];
        const Corner& b = polygon.corner[static_cast<std::size_t>((i + 1) % polygon.count)];
        const double da = distance(plane, a.clip, view);
        const double db = distance(plane, b.clip, view);
        if (da >= 0) {
            kept.add(a);
        }
        if (da >= 0 && db < 0) {
            kept.add(cut(a, da, b, db));
        } else if (da < 0 && db >= 0) {
            kept.add(cut(b, db, a, da));
        }
    }
    return kept;
}

std::int32_t snap_to_band(double pixels) {
    const double limit = guard_band;
    return snap(static_cast<float>(std::clamp(pixels, -limit, limit)));
}

ScreenVertex place(const Corner& c, const View& view, const VertexBuffer& vertices) {
    if (c.vertex >= 0) {
        const auto known = static_cast<std::size_t>(c.vertex);
        if (vertices[known].x != needs_clipping) {
            return vertices[known];
        }
    }
    const WindowPosition<double> p = window_position(c.clip, view);
    return {snap_to_band(p.x), snap_to_band(p.y), static_cast<float>(p.z),
            static_cast<float>(p.inverse_w)};
}

bool finite(const glm::dvec4& p) {
    return std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z) && std::isfinite(p.w);
}

}  // namespace

bool clip_triangle(const Mesh& mesh, std::uint32_t source, const View& view,
                   const VertexBuffer& vertices, std::vector<ScreenTriangle>& out) {
    Polygon polygon;
    for (int i = 0; i < 3; ++i) {
        const std::uint32_t vertex = mesh.triangles[source][i];
        const glm::dvec3 p = mesh.positions[vertex];
        Corner corner{clip_position(view.clip_from_world, p.x, p.y, p.z), glm::dvec3(0), vertex};
        corner.barycentric[i] = 1;
        if (!finite(corner.clip)) {
            return false;
        }
        polygon.add(corner);
    }
    for (int plane = 0; plane < plane_count && polygon.count > 0; ++plane) {
        polygon = clip(polygon, plane, view);
    }
    for (int i = 1; i + 1 < polygon.count; ++i) {
        ScreenTriangle piece{.v = {}, .source = source, .clipped = true};
        int k = 0;
        for (const int at : {0, i, i + 1}) {
            const Corner& c = polygon.corner[static_cast<std::size_t>(at)];
            piece.v[k] = place(c, view, vertices);
            piece.barycentric[k++] = glm::vec3(c.barycentric);
        }
        out.push_back(piece);
    }
    return true;
}

}  // namespace glint
