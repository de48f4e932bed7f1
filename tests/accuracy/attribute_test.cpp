// The error of interpolated attributes, of slivers and of large triangles far from the window's
// corner: the tiles' planes stay accurate where planes anchored at that corner fail.
#include "framework/raster/assemble.hpp"
#include "framework/raster/interpolate.hpp"
#include "framework/raster/plug.hpp"
#include "framework/raster/tile.hpp"
#include "tests/oracle/random.hpp"
#include "tests/unit/raster/drawing.hpp"
#include "tests/unit/raster/rays.hpp"
#include "tests/worst.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <optional>

namespace glint {
namespace {

using oracle::Random;

constexpr int width = 1000;
constexpr int height = 64;
const Camera camera{
    .eye = {0, 0, 0}, .target = {0, 0, -1}, .fov_degrees = 45, .near = 0.1F, .far = 100};

// A triangle by its window positions, each at its own distance between 1 and farthest, near the
// window's right end. Its uvs are 1, 0 and 0, 1 and 0, 0: barycentric coordinates.
Mesh any_triangle(Random& random, const Rays& rays, double flattest, double farthest) {
    const double size = std::pow(10.0, random.real(0.3, 3.5));
    const double flatness = std::pow(10.0, random.real(flattest, 0));
    const glm::dvec2 centre(random.real(700, width), random.real(0, height));
    const double turn = random.real(0, 2 * std::numbers::pi);
    const glm::dvec2 along(std::cos(turn), std::sin(turn));
    const glm::dvec2 across(-along.y, along.x);
    const glm::dvec2 corners[] = {{-0.5, 0}, {0.5, 0}, {random.real(-0.5, 0.5), flatness}};
    Mesh mesh;
    for (const glm::dvec2& c : corners) {
        const glm::dvec2 p = centre + size * (c.x * along + c.y * across);
        mesh.positions.emplace_back(rays.direction(p.x, p.y) * random.real(1, farthest));
    }
    mesh.uvs = {{1, 0}, {0, 1}, {0, 0}};
    mesh.triangles = {{0, 1, 2}};
    return mesh;
}

// Attributes as planes in float from the window's corner, as one would at first.
class NaivePlanes {
  public:
    NaivePlanes(const ScreenTriangle& t, const Edges& edges) {
        for (int i = 0; i < 3; ++i) {
            const Edge& e = edges.edge[static_cast<std::size_t>(i)];
            const double scale = static_cast<double>(t.v[i].inverse_w) /
                                 std::abs(static_cast<double>(edges.double_area));
            const glm::vec3 plane(static_cast<double>(e.a * subpixel_one) * scale,
                                  static_cast<double>(e.b * subpixel_one) * scale,
                                  static_cast<double>(e.c) * scale);
            s_ += plane;
            if (i < 2) {
                uv_[i] = plane;
            }
        }
    }
    glm::vec2 at(int x, int y) const {
        const glm::vec3 p(x + 0.5, y + 0.5, 1);
        return glm::vec2(dot(uv_[0], p), dot(uv_[1], p)) / dot(s_, p);
    }

  private:
    glm::vec3 s_{0}, uv_[2]{};
};

// How steep interpolants can be: the triangle's least height in pixels, and how depth varies.
struct Shape {
    double height, depth_ratio;
};
Shape shape_of(const ScreenTriangle& t, const Edges& edges) {
    double longest = 0;
    for (const Edge& e : edges.edge) {
        longest = std::max(longest, std::hypot(static_cast<double>(e.a), static_cast<double>(e.b)));
    }
    const auto [far, near] = std::minmax({t.v[0].inverse_w, t.v[1].inverse_w, t.v[2].inverse_w});
    return {std::abs(static_cast<double>(edges.double_area)) / longest / subpixel_one,
            double{near / far}};
}

struct Errors {
    double scanline = 0, tiles = 0, naive = 0;
    double tiles_to_bound = 0;
    int pixels = 0;

    void add(const Errors& e) {
        scanline = worse(scanline, e.scanline);
        tiles = worse(tiles, e.tiles);
        naive = worse(naive, e.naive);
        tiles_to_bound = worse(tiles_to_bound, e.tiles_to_bound);
        pixels += e.pixels;
    }
};

// What float can do with planes from a tile's corner, 64 pixels away at most.
double bound(const Shape& shape) {
    return 4 * 0x1p-24 * (1 + tile_size / shape.height) * shape.depth_ratio;
}

// Calls visit(x, y, barycentrics) for every pixel that a picture of one triangle shows it in.
template <class Visit>
void for_each_pixel(const Drawn& drawn, const ScreenTriangle& t, const Edges& edges,
                    Visit&& visit) {
    const int half = subpixel_one / 2;
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
            if (drawn.triangle(x, y) != no_triangle) {
                visit(
                    x, y,
                    barycentrics<double>(t, edges, x * subpixel_one + half, y * subpixel_one + half)
                        .space);
            }
        }
    }
}

Errors errors_of(const Mesh& mesh, const ScreenTriangle& t, const View& view) {
    const Edges edges = edges_of(t.v);
    const NaivePlanes naive(t, edges);
    const Drawn scanline = draw(mesh, view, plug(show_uv), {.rasterizer = Rasterizer::scanline});
    const Drawn tiles = draw(mesh, view, plug(show_uv), {});
    Errors e;
    for_each_pixel(scanline, t, edges, [&](int x, int y, const std::array<double, 3>& exact) {
        const auto error = [&](const glm::vec2& uv) {
            return std::max(std::abs(double{uv.x} - exact[0]), std::abs(double{uv.y} - exact[1]));
        };
        e.scanline = std::max(e.scanline, error(glm::vec2(scanline.linear(x, y))));
        e.tiles = std::max(e.tiles, error(glm::vec2(tiles.linear(x, y))));
        e.naive = std::max(e.naive, error(naive.at(x, y)));
        ++e.pixels;
    });
    e.tiles_to_bound = e.tiles / bound(shape_of(t, edges));
    return e;
}

// By the triangle's least height: below 1, 10, 100, 1000 pixels, and above.
constexpr int classes = 5;
std::array<Errors, classes> measured() {
    const View view{clip_from_world(camera, static_cast<float>(width) / height), width, height};
    const Rays rays(camera, width, height);
    std::array<Errors, classes> by_height{};
    for (std::uint64_t seed = 1; seed <= 700; ++seed) {
        Random random(seed);
        const Mesh mesh = any_triangle(random, rays, -2.5, 4);
        const auto triangles = assemble(mesh, view).triangles;
        if (triangles.size() != 1 || triangles[0].clipped ||
            edges_of(triangles[0].v).double_area == 0) {
            continue;
        }
        const double least = shape_of(triangles[0], edges_of(triangles[0].v)).height;
        const double step = std::clamp(std::floor(std::log10(least)) + 1, 0.0, classes - 1.0);
        by_height[static_cast<std::size_t>(step)].add(errors_of(mesh, triangles[0], view));
    }
    return by_height;
}

TEST_CASE("attributes are accurate whatever the triangle's shape and place") {
    double below = 1;  // pixels of height
    for (const Errors& e : measured()) {
        CAPTURE(below);
        MESSAGE("height below ", below, " px, ", e.pixels, " px: scanline ", e.scanline, ", tiles ",
                e.tiles, ", from the window's corner ", e.naive, ", ", e.tiles_to_bound);
        CHECK(e.pixels > 300);
        CHECK(e.scanline < 4e-7);  // exact edges at every pixel: a few roundings
        CHECK(e.tiles_to_bound < 1);
        CHECK((below > 100 || e.naive > 5 * e.tiles));
        below *= 10;
    }
}

// The largest error of what tiles show, by error_at(shown, barycentrics), over random triangles of
// at least this flatness (10^flattest) and corners up to `farthest` times as far as the nearest.
template <class S, class Prepare, class ErrorAt>
double largest_error(double flattest, double farthest, const S& shader, Prepare&& prepare,
                     ErrorAt&& error_at) {
    const View view{clip_from_world(camera, static_cast<float>(width) / height), width, height};
    const Rays rays(camera, width, height);
    double worst = 0;
    int pixels = 0;
    for (std::uint64_t seed = 1; seed <= 700; ++seed) {
        Random random(seed);
        Mesh mesh = any_triangle(random, rays, flattest, farthest);
        const auto triangles = assemble(mesh, view).triangles;
        if (triangles.size() != 1 || triangles[0].clipped) {
            continue;
        }
        const ScreenTriangle& t = triangles[0];
        prepare(t, mesh);
        const Drawn drawn = draw(mesh, view, plug(shader), {});
        for_each_pixel(drawn, t, edges_of(t.v),
                       [&](int x, int y, const std::array<double, 3>& exact) {
                           worst = worse(worst, error_at(drawn.linear(x, y), exact, mesh));
                           ++pixels;
                       });
    }
    CHECK(pixels > 10000);
    MESSAGE(pixels, " px: ", worst);
    return worst;
}

// A smooth attribute, as that of a curved surface is, differs little between corners that lie side
// by side: then it is not steep in slivers either, though its planes are differences of steep ones.
TEST_CASE("what varies slowly is accurate in slivers") {
    const double error = largest_error(
        -4, 1, show_uv,
        [](const ScreenTriangle& t, Mesh& mesh) {
            for (std::size_t i = 0; i < 3; ++i) {
                mesh.uvs[i] = glm::vec2(t.v[i].x, t.v[i].y) / (256.0F * width);
            }
        },
        [](const Rgb<float>& shown, const std::array<double, 3>& weight, const Mesh& mesh) {
            glm::dvec2 uv(0);
            for (std::size_t i = 0; i < 3; ++i) {
                uv += weight[i] * glm::dvec2(mesh.uvs[i]);
            }
            return length(glm::dvec2(shown) - uv);
        });
    CHECK(error < 1e-6);
}

// The eye is at the origin: an error counts by how far away it is.
TEST_CASE("positions near the eye are accurate on triangles that reach far") {
    const double error = largest_error(
        -0.5, 100, show_position, [](const ScreenTriangle&, const Mesh&) {},
        [](const Rgb<float>& shown, const std::array<double, 3>& weight, const Mesh& mesh) {
            glm::dvec3 position(0);
            for (std::size_t i = 0; i < 3; ++i) {
                position += weight[i] * glm::dvec3(mesh.positions[i]);
            }
            return length(glm::dvec3(shown) - position) / length(position);
        });
    CHECK(error < 1e-5);
}

}  // namespace
}  // namespace glint
