#include "framework/raster/large_planes.hpp"

#include "framework/raster/interpolate.hpp"

#include <algorithm>
#include <cstdlib>

namespace glint {
namespace {

// Screen barycentrics over w, in double, from the exact edges of a triangle: they are linear in the
// window.
class BarycentricsOverW {
  public:
    explicit BarycentricsOverW(const ScreenTriangle& t) : t_(t), edges_(edges_of(t.v)) {}

    // At the corner of pixel x, y.
    glm::dvec3 at(int x, int y) const {
        return scaled([&](const Edge& e) {
            return e.at(x * subpixel_one, y * subpixel_one) + (e.inclusive ? 0 : 1);
        });
    }
    // How they change a pixel right, and a pixel down.
    glm::dvec3 right() const {
        return scaled([](const Edge& e) { return e.a * subpixel_one; });
    }
    glm::dvec3 down() const {
        return scaled([](const Edge& e) { return e.b * subpixel_one; });
    }

  private:
    template <class OfEdge>
    glm::dvec3 scaled(OfEdge&& of_edge) const {
        const double scale = 1.0 / static_cast<double>(std::abs(edges_.double_area));
        glm::dvec3 b;
        for (int i = 0; i < 3; ++i) {
            b[i] = static_cast<double>(of_edge(edges_.edge[static_cast<std::size_t>(i)])) * scale *
                   static_cast<double>(t_.v[i].inverse_w);
        }
        return b;
    }

    const ScreenTriangle& t_;
    Edges edges_;
};

double sum(const glm::dvec3& v) {
    return v.x + v.y + v.z;
}

std::size_t nearest_corner(const ScreenTriangle& t) {
    const float w[] = {t.v[0].inverse_w, t.v[1].inverse_w, t.v[2].inverse_w};
    return static_cast<std::size_t>(std::max_element(w, w + 3) - w);
}

}  // namespace

void set_up_large_planes(const Frame& frame, const TileBuffer& tile, const ScreenTriangle& triangle,
                         const Shader& shader, std::size_t lanes, float* planes) {
    const BarycentricsOverW over_w(triangle);
    const glm::dvec3 right = over_w.right();
    const glm::dvec3 down = over_w.down();
    int x = sum(right) < 0 ? tile_size : 0;
    int y = sum(down) < 0 ? tile_size : 0;
    glm::dvec3 at = over_w.at(tile.x + x, tile.y + y);
    if (!(sum(at) > 0)) {
        x = tile_size - x;
        y = tile_size - y;
        at = over_w.at(tile.x + x, tile.y + y);
    }
    const double unit = 1.0 / sum(at);
    planes[0] = static_cast<float>(x);
    planes[lanes] = static_cast<float>(y);
    planes[2 * lanes] = static_cast<float>(sum(right) * unit);
    planes[3 * lanes] = static_cast<float>(sum(down) * unit);

    const CornerVaryings c = corner_varyings(shader, *frame.mesh, triangle);
    const std::size_t nearest = nearest_corner(triangle);
    const auto count = static_cast<std::size_t>(shader.varyings);
    for (std::size_t k = 0; k < count; ++k) {
        const double first = shader.directions_only ? 0.0 : static_cast<double>(c[nearest][k]);
        const glm::dvec3 rise = (glm::dvec3(c[0][k], c[1][k], c[2][k]) - first) * unit;
        float* out = planes + (4 + k) * lanes;
        const auto at_anchor = static_cast<float>(dot(rise, at));
        out[0] = shader.directions_only ? at_anchor : c[nearest][k];
        out[count * lanes] = static_cast<float>(dot(rise, right));
        out[2 * count * lanes] = static_cast<float>(dot(rise, down));
        out[3 * count * lanes] = at_anchor;
    }
}

}  // namespace glint
