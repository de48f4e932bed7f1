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
    const ScreenVertex* known = nullptr;  // a vertex that has its place already
};

// A triangle and one more corner for each of the six planes.
struct Polygon {
    std::array<Corner, 9> corner;
    int count = 0;
    void add(const Corner& c) { corner[static_cast<std::size_t>(count++)] = c; }
};

// A plane that bounds one component of clip space: component >= least of w, or least of 1; or the
// other way round, component <= most of w.
struct Plane {
    int component;
    double bound;
    double sign;       // of the component in the distance
    bool of_w = true;  // the bound is a multiple of w

    double limit(const glm::dvec4& p) const { return of_w ? bound * p.w : bound; }
    // Signed, up to scale; positive inside.
    double distance(const glm::dvec4& p) const { return sign * (p[component] - limit(p)); }
};

// The eye, near, and the guard band: left, right, top, bottom.
std::array<Plane, 6> planes(const View& view) {
    const double x = 2.0 * guard_band / view.width;
    const double y = 2.0 * guard_band / view.height;
    return {{{3, static_cast<double>(smallest_w), 1, false},
             {2, 1, -1},
             {0, -x - 1, 1},
             {0, x - 1, -1},
             {1, 1 + y, -1},
             {1, 1 - y, 1}}};
}

// Who has a place is inside, by however little rounding says otherwise here: the neighbours that
// are not clipped take it from there.
double inside_by(const Plane& plane, const Corner& c) {
    const double d = plane.distance(c.clip);
    return c.known != nullptr ? std::max(d, 0.0) : d;
}

// Always from the inside to the outside: the same point whichever triangle asks. Weights are
// positive, so w does not cancel; and what is cut is on the plane, whatever the rounding.
Corner cut(const Plane& plane, const Corner& inside, const Corner& outside) {
    const double in = inside_by(plane, inside);
    const double out = -inside_by(plane, outside);
    const double a = out / (in + out);
    const double b = in / (in + out);
    Corner c{a * inside.clip + b * outside.clip, a * inside.barycentric + b * outside.barycentric};
    c.clip[plane.component] = plane.limit(c.clip);
    return c;
}

// The corners inside, and where the outline leaves and enters. Of slivers as thin as rounding the
// outline may do that twice: then what lies between the first of each is kept, so that no polygon
// grows by more than one corner.
Polygon clip(const Polygon& polygon, const Plane& plane) {
    const auto corner = [&](int i) -> const Corner& {
        return polygon.corner[static_cast<std::size_t>(i % polygon.count)];
    };
    const auto inside = [&](int i) { return inside_by(plane, corner(i)) >= 0; };
    int first = 0;  // the first corner inside, after one outside
    while (first < polygon.count && (!inside(first) || inside(first + polygon.count - 1))) {
        ++first;
    }
    if (first == polygon.count) {  // all of it, or nothing
        return inside(0) ? polygon : Polygon{};
    }
    Polygon kept;
    kept.add(cut(plane, corner(first), corner(first + polygon.count - 1)));
    int last = first;
    for (; inside(last); ++last) {
        kept.add(corner(last));
    }
    kept.add(cut(plane, corner(last - 1), corner(last)));
    return kept;
}

std::int32_t snap_to_band(double pixels) {
    const double limit = guard_band;
    return snap(static_cast<float>(std::clamp(pixels, -limit, limit)));
}

ScreenVertex place(const Corner& c, const View& view) {
    if (c.known != nullptr) {
        return *c.known;
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
        Corner corner{clip_position(view.clip_from_world, p.x, p.y, p.z), glm::dvec3(0)};
        corner.barycentric[i] = 1;
        corner.known = vertices[vertex].x != needs_clipping ? &vertices[vertex] : nullptr;
        if (!finite(corner.clip)) {
            return false;
        }
        polygon.add(corner);
    }
    for (const Plane& plane : planes(view)) {
        polygon = polygon.count > 0 ? clip(polygon, plane) : polygon;
    }
    for (int i = 1; i + 1 < polygon.count; ++i) {
        ScreenTriangle piece{.v = {}, .source = source, .clipped = true};
        int k = 0;
        for (const int at : {0, i, i + 1}) {
            const Corner& c = polygon.corner[static_cast<std::size_t>(at)];
            piece.v[k] = place(c, view);
            piece.barycentric[k++] = c.barycentric;
        }
        out.push_back(piece);
    }
    return true;
}

}  // namespace glint
