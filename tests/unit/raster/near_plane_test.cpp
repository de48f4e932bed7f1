// What passes through the near plane, the eye or the guard band.
#include "framework/scene/camera.hpp"
#include "framework/raster/assemble.hpp"
#include "framework/raster/plug.hpp"
#include "framework/geometry/shapes.hpp"
#include "tests/oracle/coverage_oracle.hpp"
#include "tests/oracle/random.hpp"
#include "tests/unit/raster/drawing.hpp"
#include "tests/unit/raster/rays.hpp"

#include <doctest/doctest.h>

#include <limits>
#include <numbers>
#include <numeric>
#include <optional>

namespace glint {
namespace {

using oracle::Random;

constexpr float infinity = std::numeric_limits<float>::infinity();
constexpr float nan = std::numeric_limits<float>::quiet_NaN();

View view_of(const Camera& camera, int width, int height) {
    return {clip_from_world(camera, static_cast<float>(width) / static_cast<float>(height)), width,
            height};
}

// How many of the assembled triangles cover each pixel's centre, by exact arithmetic.
Image<int> times_covered(const Mesh& mesh, const View& view) {
    Image<int> count(view.width, view.height, 0);
    std::vector<oracle::Run> runs;
    for (const ScreenTriangle& t : assemble(mesh, view).triangles) {
        const oracle::Triangle triangle{oracle::Point{t.v[0].x, t.v[0].y},
                                        oracle::Point{t.v[1].x, t.v[1].y},
                                        oracle::Point{t.v[2].x, t.v[2].y}};
        runs.clear();
        append_runs(triangle, oracle::sample_positions(1)[0], view.width, view.height, runs);
        for (const oracle::Run& run : runs) {
            for (int x = run.x_begin; x < run.x_end; ++x) {
                ++count(x, run.y);
            }
        }
    }
    return count;
}

// Pixels that are covered another number of times than expected(x, y) says, if it does.
template <class Expected>
int wrong_pixels(const Image<int>& count, Expected&& expected) {
    int wrong = 0;
    for (int y = 0; y < count.height(); ++y) {
        for (int x = 0; x < count.width(); ++x) {
            const std::optional<int> times = expected(x, y);
            wrong += times && *times != count(x, y) ? 1 : 0;
        }
    }
    return wrong;
}

Image<int> drawn_pixels(const Drawn& picture) {
    Image<int> count(picture.triangle.width(), picture.triangle.height());
    for (int y = 0; y < count.height(); ++y) {
        for (int x = 0; x < count.width(); ++x) {
            count(x, y) = picture.triangle(x, y) == no_triangle ? 0 : 1;
        }
    }
    return count;
}

// A square of the ground whose vertices are moved about in it: still the same square.
Mesh crooked_ground(Random& random, float side, int cells) {
    Mesh mesh = plane(side, side, cells, cells);
    const float jitter = 0.2F * side / static_cast<float>(cells);
    for (glm::vec3& p : mesh.positions) {
        if (std::max(std::abs(p.x), std::abs(p.z)) < 0.4999F * side) {
            p.x += jitter * static_cast<float>(random.real(-1, 1));
            p.z += jitter * static_cast<float>(random.real(-1, 1));
        }
    }
    return mesh;
}

// Whether a square of the ground is seen at a window position, not nearer than the near plane.
bool sees_ground(const Rays& rays, const Camera& camera, double half_side, double x, double y) {
    const glm::dvec3 d = rays.direction(x, y);
    const double distance = -rays.origin.y / d.y;
    const glm::dvec3 hit = rays.origin + distance * d;
    return distance >= double{camera.near} && std::abs(hit.x) <= half_side &&
           std::abs(hit.z) <= half_side;
}

// As many as at the pixel's centre; nothing is said where that changes within 0.05 pixel.
std::optional<int> ground_pixel(const Rays& rays, const Camera& camera, double half_side, int x,
                                int y) {
    const auto seen = [&](double dx, double dy) {
        return sees_ground(rays, camera, half_side, x + 0.5 + dx, y + 0.5 + dy);
    };
    const bool centre = seen(0, 0);
    for (const double offset : {-0.05, 0.05}) {
        if (seen(offset, offset) != centre || seen(offset, -offset) != centre) {
            return std::nullopt;
        }
    }
    return centre ? 1 : 0;
}

TEST_CASE("a ground of many triangles through eye and near plane has no hole and no pixel twice") {
    int nearer = 0;
    for (std::uint64_t seed = 1; seed <= 60; ++seed) {
        CAPTURE(seed);
        Random random(seed);
        const float height = static_cast<float>(std::pow(10.0, random.real(-2, 0.5)));
        const double heading = random.real(0, 2 * std::numbers::pi);
        const double pitch = random.real(-1.4, 0.3);
        Camera camera{.eye = {random.real(-1, 1), height, random.real(-1, 1)}};
        camera.target = camera.eye + glm::vec3(std::cos(pitch) * std::sin(heading), std::sin(pitch),
                                               std::cos(pitch) * std::cos(heading));
        camera.up = {random.real(-0.5, 0.5), 1, random.real(-0.5, 0.5)};
        camera.fov_degrees = static_cast<float>(random.real(20, 150));
        camera.near = 0.1F;
        camera.far = 1000;
        const Mesh mesh = crooked_ground(random, 20, random.between(1, 12));
        const View view = view_of(camera, 97, 61);
        const Rays rays(camera, view.width, view.height);
        const auto expected = [&](int x, int y) { return ground_pixel(rays, camera, 10, x, y); };
        const Image<int> count = times_covered(mesh, view);
        CHECK(wrong_pixels(count, expected) == 0);
        nearer += camera.eye.y < camera.near ? 1 : 0;
        for (const Settings& settings : both_rasterizers()) {
            CAPTURE(words(settings));
            CHECK(drawn_pixels(draw(mesh, view, plug(show_position), settings)) == count);
        }
    }
    CHECK(nearer > 10);  // often enough the near plane cut the ground within the picture
}

TEST_CASE("a closed mesh round the eye covers every pixel once") {
    for (std::uint64_t seed = 1; seed <= 30; ++seed) {
        CAPTURE(seed);
        Random random(seed);
        Camera camera{
            .eye = {random.real(-0.3, 0.3), random.real(-0.3, 0.3), random.real(-0.3, 0.3)},
            .target = {random.real(-1, 1), random.real(-1, 1), 1},
            .up = {random.real(-1, 1), 1, 0},
            .fov_degrees = static_cast<float>(random.real(10, 170)),
            .near = 1e-3F,
            .far = 10};
        const Mesh mesh = icosphere(1, random.between(0, 4));
        const View view = view_of(camera, random.between(1, 130), random.between(1, 130));
        const Image<int> count = times_covered(mesh, view);
        CHECK(wrong_pixels(count, [](int, int) { return 1; }) == 0);
        for (const Settings& settings : both_rasterizers()) {
            CAPTURE(words(settings));
            CHECK(drawn_pixels(draw(mesh, view, plug(show_position), settings)) == count);
        }
    }
}

// The eye at the origin looks along -z; near, far and the depths between are exact in float.
const Camera simple_eye{
    .eye = {0, 0, 0}, .target = {0, 0, -1}, .fov_degrees = 90, .near = 0.5F, .far = 1.5F};

Mesh one_triangle(const glm::vec3& a, const glm::vec3& b, const glm::vec3& c) {
    return {.positions = {a, b, c},
            .normals = {},
            .uvs = {},
            .triangles = {{0, 1, 2}},
            .materials = {}};
}

int drawn_count(const Mesh& mesh, const View& view, const Settings& settings) {
    const Drawn d = draw(mesh, view, plug(show_position), settings);
    CHECK(d.statistics.triangles_not_finite == 0);
    const Image<int> count = drawn_pixels(d);
    return std::accumulate(count.pixels().begin(), count.pixels().end(), 0);
}

TEST_CASE("what lies behind or touches the eye plane from behind is not drawn") {
    const View view = view_of(simple_eye, 32, 32);
    const Mesh behind = one_triangle({-9, -9, 1}, {9, -9, 1}, {0, 9, 1});
    const Mesh touching = one_triangle({-9, -9, 1}, {9, -9, 1}, {0, 9, 0});
    const Mesh in_the_eye_plane = one_triangle({-9, -9, 0}, {9, -9, 0}, {0, 9, 0});
    const Mesh in_the_eye = one_triangle({0, 0, 0}, {0, 0, 0}, {0, 0, 0});
    const Mesh before_near = one_triangle({-9, -9, -0.4F}, {9, -9, -0.4F}, {0, 9, -0.4F});
    for (const Settings& settings : both_rasterizers()) {
        CAPTURE(words(settings));
        for (const Mesh& mesh : {behind, touching, in_the_eye_plane, in_the_eye, before_near}) {
            CHECK(drawn_count(mesh, view, settings) == 0);
        }
    }
}

TEST_CASE("a corner in the eye plane goes to infinity, up to the near plane it is drawn") {
    const View view = view_of(simple_eye, 32, 32);
    // At distance d this triangle is at y = 1 - 2 d, and as wide as the window.
    const Mesh mesh = one_triangle({0, 1, 0}, {-1, -1, -1}, {1, -1, -1});
    for (const Settings& settings : both_rasterizers()) {
        CAPTURE(words(settings));
        const Drawn d = draw(mesh, view, plug(show_position), settings);
        const auto expected = [](int, int y) { return y < 16 ? 0 : 1; };
        CHECK(wrong_pixels(drawn_pixels(d), expected) == 0);
    }
}

TEST_CASE("exactly on the near plane is in") {
    const View view = view_of(simple_eye, 32, 32);
    Camera nearer = simple_eye;
    nearer.near = 0.25F;
    const View reference = view_of(nearer, 32, 32);
    const Mesh on = one_triangle({-0.4F, -0.4F, -0.5F}, {0.45F, -0.4F, -0.5F}, {0, 0.45F, -0.5F});
    for (const Settings& settings : both_rasterizers()) {
        CAPTURE(words(settings));
        const Drawn d = draw(on, view, plug(show_position), settings);
        CHECK(d.triangle == draw(on, reference, plug(show_position), settings).triangle);
        CHECK(d.triangle(16, 16) == 0);
        CHECK(d.depth(16, 16) == 1.0F);
    }
}

TEST_CASE("exactly on the far plane is out") {
    const View view = view_of(simple_eye, 32, 32);
    const Mesh on = one_triangle({-9, -9, -1.5F}, {9, -9, -1.5F}, {0, 9, -1.5F});
    const Mesh before = one_triangle({-9, -9, -1.49F}, {9, -9, -1.49F}, {0, 9, -1.49F});
    for (const Settings& settings : both_rasterizers()) {
        CAPTURE(words(settings));
        CHECK(drawn_count(on, view, settings) == 0);
        CHECK(drawn_count(before, view, settings) == 32 * 32);
    }
}

TEST_CASE("triangles of a vertex that is not finite are dropped and counted, others are unharmed") {
    Random random(7);
    const Camera camera{.eye = {0, 2, 3}, .fov_degrees = 50, .near = 0.1F, .far = 50};
    const View view = view_of(camera, 130, 70);
    const Mesh mesh = crooked_ground(random, 8, 9);
    for (const float bad : {nan, infinity, -infinity}) {
        for (int component = 0; component < 3; ++component) {
            Mesh spoiled = mesh;
            std::vector<bool> hurt(mesh.triangles.size(), false);
            std::int64_t dropped = 0;
            spoiled.positions[44][component] = bad;
            spoiled.positions[71][component] = bad;
            for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
                for (int i = 0; i < 3; ++i) {
                    const auto v = mesh.triangles[t][i];
                    hurt[t] = hurt[t] || v == 44 || v == 71;
                }
                dropped += hurt[t] ? 1 : 0;
            }
            for (const Settings& settings : both_rasterizers()) {
                CAPTURE(words(settings));
                const Drawn whole = draw(mesh, view, plug(show_position), settings);
                const Drawn d = draw(spoiled, view, plug(show_position), settings);
                CHECK(d.statistics.triangles_not_finite == dropped);
                int wrong = 0;
                for (int y = 0; y < view.height; ++y) {
                    for (int x = 0; x < view.width; ++x) {
                        const std::int32_t t = whole.triangle(x, y);
                        const bool gone = t == no_triangle || hurt[static_cast<std::size_t>(t)];
                        wrong += d.triangle(x, y) != (gone ? no_triangle : t) ? 1 : 0;
                        wrong += d.depth(x, y) != (gone ? 0.0F : whole.depth(x, y)) ? 1 : 0;
                        wrong += d.linear(x, y) != (gone ? Rgb<float>(0) : whole.linear(x, y));
                    }
                }
                CHECK(wrong == 0);
            }
        }
    }
}

TEST_CASE("a view that is not finite draws nothing") {
    View view = view_of(simple_eye, 16, 16);
    view.clip_from_world[3][3] = nan;
    const Mesh mesh = one_triangle({-9, -9, -1}, {9, -9, -1}, {0, 9, -1});
    for (const Settings& settings : both_rasterizers()) {
        CAPTURE(words(settings));
        const Drawn d = draw(mesh, view, plug(show_position), settings);
        CHECK(d.statistics.triangles_not_finite == 1);
        CHECK(d.statistics.triangles_visible == 0);
    }
}

TEST_CASE("triangles far beyond the guard band cover all without cracks") {
    for (std::uint64_t seed = 1; seed <= 40; ++seed) {
        CAPTURE(seed);
        Random random(seed);
        const View view = window_view(random.between(1, 200), random.between(1, 100));
        const auto far = [&] { return static_cast<float>(std::pow(10.0, random.real(3, 12))); };
        // A fan round a point in the window, its rim far outside.
        Mesh mesh;
        mesh.positions.push_back({random.real(0, view.width), random.real(0, view.height), 0.5F});
        const auto rim = static_cast<std::uint32_t>(random.between(4, 9));
        for (std::uint32_t i = 0; i < rim; ++i) {
            const double angle = 2 * std::numbers::pi * (i + random.real(0.1, 0.4)) / rim;
            const float r = far();
            mesh.positions.push_back({r * static_cast<float>(std::cos(angle)),
                                      r * static_cast<float>(std::sin(angle)), 0.5F});
            mesh.triangles.push_back({0, 1 + i, 1 + (i + 1) % rim});
        }
        const Image<int> count = times_covered(mesh, view);
        CHECK(wrong_pixels(count, [](int, int) { return 1; }) == 0);
        for (const Settings& settings : both_rasterizers()) {
            CAPTURE(words(settings));
            const Drawn d = draw(mesh, view, plug(show_position), settings);
            CHECK(drawn_pixels(d) == count);
            const auto depths = d.depth.pixels();
            CHECK(std::ranges::all_of(depths, [](float z) { return z == 0.5F; }));
        }
    }
}

}  // namespace
}  // namespace glint
