// What is interpolated: planes anchored far away, and perspective.
#include "framework/scene/camera.hpp"
#include "framework/raster/assemble.hpp"
#include "framework/raster/interpolate.hpp"
#include "framework/raster/plug.hpp"
#include "framework/geometry/shapes.hpp"
#include "tests/stability/row.hpp"
#include "tests/unit/raster/drawing.hpp"
#include "tests/unit/raster/rays.hpp"

#include <algorithm>

namespace glint::stability {
namespace {

// u/w, v/w and 1/w as planes from the window's corner, in T.
template <Real T>
glm::dvec2 uv_from_window_corner(const ScreenTriangle& t, const Edges& edges, int x, int y) {
    double sum[3];  // of u/w, v/w, 1/w; uv is barycentric
    for (std::size_t i = 0; i < 3; ++i) {
        const Edge& e = edges.edge[i];
        const T scale = T(t.v[i].inverse_w) / T(static_cast<float>(std::abs(edges.double_area)));
        const T a = T(static_cast<float>(e.a * subpixel_one)) * scale;
        const T b = T(static_cast<float>(e.b * subpixel_one)) * scale;
        const T c = T(static_cast<float>(e.c)) * scale;
        sum[i] = value(a * T(x + 0.5) + (b * T(y + 0.5) + c));
    }
    return glm::dvec2(sum[0], sum[1]) / (sum[0] + sum[1] + sum[2]);
}

TEST_CASE("planes from the window's corner: a sliver at its far end") {
    constexpr int width = 16000;
    constexpr int height = 40;
    const View view = window_view(width, height);
    Mesh sliver;
    sliver.positions = {{15450.2F, 2.1F, 0.5F}, {15995.7F, 36.3F, 0.5F}, {15700.3F, 17.8F, 0.5F}};
    sliver.uvs = {{1, 0}, {0, 1}, {0, 0}};
    sliver.triangles = {{0, 1, 2}};
    const ScreenTriangle t = assemble(sliver, view).triangles.at(0);
    const Edges edges = edges_of(t.v);
    row(in_all_numbers([&]<Real T>() {
            const Drawn d = draw(sliver, view, plug(show_uv), settings_of<T>());
            Errors worst;
            for (int y = 0; y < height; ++y) {
                for (int x = 15400; x < width; ++x) {
                    if (d.triangle(x, y) == no_triangle) {
                        continue;
                    }
                    const auto b = barycentrics<double>(t, edges, 256 * x + 128, 256 * y + 128);
                    const glm::dvec2 exact(b.space[0], b.space[1]);
                    const glm::dvec2 naive = uv_from_window_corner<T>(t, edges, x, y);
                    const glm::dvec2 shown = glm::vec2(d.linear(x, y));
                    add(worst, {length(naive - exact), length(shown - exact)});
                }
            }
            return worst;
        }),
        2e-3, 1e-4);
}

constexpr int side = 96;
const Camera camera{
    .eye = {0.3F, 1, 0.1F}, .target = {5, 0.2F, -7}, .fov_degrees = 60, .near = 0.1F, .far = 1e4F};

// The point of the mesh that is seen at a pixel by screen barycentrics, without 1/w.
struct Affine {
    std::vector<ScreenTriangle> triangles;
    const Mesh& mesh;

    glm::dvec3 at(int x, int y, int source) const {
        for (const ScreenTriangle& t : triangles) {
            const Edges edges = edges_of(t.v);
            const auto b = barycentrics<double>(t, edges, 256 * x + 128, 256 * y + 128);
            if (static_cast<int>(t.source) != source || std::ranges::min(b.screen) < 0) {
                continue;
            }
            glm::dvec3 p(0);
            for (int i = 0; i < 3; ++i) {
                for (int j = 0; j < 3; ++j) {
                    p += b.screen[static_cast<std::size_t>(i)] * double{t.barycentric[i][j]} *
                         glm::dvec3(mesh.positions[mesh.triangles[t.source][j]]);
                }
            }
            return p;
        }
        return {};
    }
};

Rgb<float> checker(const glm::dvec3& p) {
    const bool light = (std::lround(std::floor(p.x)) + std::lround(std::floor(p.z))) % 2 == 0;
    return light ? Rgb<float>(0.6F) : Rgb<float>(0.05F);
}

TEST_CASE("no 1/w: a plane to the horizon") {
    const Mesh floor = plane(2000, 2000, 1, 1);
    const View view{clip_from_world(camera, 1), side, side};
    const Rays rays(camera, side, side);
    const Affine affine{assemble(floor, view).triangles, floor};
    const auto off = [&](const glm::dvec3& point, int x, int y) {  // pixels
        return length(glm::dvec2(rays.project(point)) - glm::dvec2(x + 0.5, y + 0.5));
    };
    const Drawn shown = draw(floor, view, plug(show_position), {});
    const auto shade = [&](bool naive) {
        return [&, naive](int x, int y) {
            const int t = shown.triangle(x, y);
            return t < 0 ? Rgb<float>(0.1F, 0.2F, 0.4F)
                         : checker(naive ? affine.at(x, y, t) : glm::dvec3(shown.linear(x, y)));
        };
    };
    picture("no_1_over_w", side, side, 2, shade(true), shade(false));
    row(in_all_numbers([&]<Real T>() {
            const Drawn d = draw(floor, view, plug(show_position), settings_of<T>());
            Errors worst;
            for (int y = 0; y < side; ++y) {
                for (int x = 0; x < side; ++x) {
                    if (const int t = d.triangle(x, y); t >= 0) {
                        add(worst,
                            {off(affine.at(x, y, t), x, y), off(glm::dvec3(d.linear(x, y)), x, y)});
                    }
                }
            }
            return worst;
        }),
        20, 0.02);
}

}  // namespace
}  // namespace glint::stability
