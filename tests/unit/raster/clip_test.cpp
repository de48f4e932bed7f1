#include "framework/raster/clip.hpp"

#include "framework/scene/camera.hpp"
#include "framework/raster/transform.hpp"
#include "framework/geometry/mesh.hpp"
#include "tests/oracle/random.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace glint {
namespace {

using oracle::Random;

// Near at 1, far at 3: depth is (3 / d - 1) / 2, clip z = (3 - d) / 2, both simple numbers.
View view_from_origin(int width = 256, int height = 128) {
    const Camera camera{
        .eye = {0, 0, 0}, .target = {0, 0, -1}, .fov_degrees = 90, .near = 1, .far = 3};
    return {clip_from_world(camera, static_cast<float>(width) / static_cast<float>(height)), width,
            height};
}

VertexBuffer transformed(const Mesh& mesh, const View& view) {
    VertexBuffer vertices(mesh.positions.size());
    transform(mesh.positions, view, 1, 0, mesh.positions.size(), vertices);
    return vertices;
}

struct Clipped {
    bool finite;
    std::vector<ScreenTriangle> pieces;
};

Clipped clip(const Mesh& mesh, const View& view, std::uint32_t triangle = 0) {
    Clipped c{};
    c.finite = clip_triangle(mesh, triangle, view, transformed(mesh, view), c.pieces);
    return c;
}

Mesh triangles_of(const LineVector<glm::vec3>& positions) {
    Mesh mesh{.positions = positions, .normals = {}, .uvs = {}, .triangles = {}, .materials = {}};
    for (std::uint32_t i = 0; i + 2 < positions.size(); i += 3) {
        mesh.triangles.push_back({i, i + 1, i + 2});
    }
    return mesh;
}

// Share of the mesh's triangle that the pieces are.
double share(const std::vector<ScreenTriangle>& pieces) {
    double sum = 0;
    for (const ScreenTriangle& t : pieces) {
        const glm::dvec2 a(t.barycentric[0]);
        const glm::dvec2 ab = glm::dvec2(t.barycentric[1]) - a;
        const glm::dvec2 ac = glm::dvec2(t.barycentric[2]) - a;
        sum += std::abs(ab.x * ac.y - ab.y * ac.x);
    }
    return sum;
}

TEST_CASE("the near plane cuts off what is nearer") {
    const View view = view_from_origin();
    const glm::vec3 a(-1, 0, -2);
    const glm::vec3 b(1, 0, -2);
    const glm::vec3 nearer(0, 1, 0);  // half of either edge to it is too near
    const Clipped one = clip(triangles_of({a, b, nearer}), view);
    CHECK(one.finite);
    CHECK(one.pieces.size() == 2);
    CHECK(share(one.pieces) == doctest::Approx(0.75));
    const Clipped two = clip(triangles_of({{-1, 0, 0}, {1, 0, 0}, {0, 1, -2}}), view);
    CHECK(two.pieces.size() == 1);
    CHECK(share(two.pieces) == doctest::Approx(0.25));
}

TEST_CASE("what lies outside leaves nothing") {
    const View view = view_from_origin();
    CHECK(clip(triangles_of({{-1, 0, 2}, {1, 0, 2}, {0, 1, 2}}), view).pieces.empty());
    CHECK(clip(triangles_of({{-1, 0, 0}, {1, 0, 0}, {0, 1, 0}}), view).pieces.empty());
    CHECK(clip(triangles_of({{-1, 0, -0.9F}, {1, 0, -0.9F}, {0, 1, -0.9F}}), view).pieces.empty());
    CHECK(clip(triangles_of({{1e6F, 0, -2}, {2e6F, 0, -2}, {2e6F, 1, -2}}), view).pieces.empty());
    CHECK(clip(triangles_of({{0, 1e6F, -2}, {1, 1e6F, -2}, {2, 2e6F, -2}}), view).pieces.empty());
}

TEST_CASE("what is not finite is refused") {
    const View view = view_from_origin();
    for (const float bad :
         {std::numeric_limits<float>::quiet_NaN(), std::numeric_limits<float>::infinity(),
          -std::numeric_limits<float>::infinity()}) {
        for (int i = 0; i < 9; ++i) {
            Mesh mesh = triangles_of({{-1, 0, -2}, {1, 0, -2}, {0, 1, 0}});
            mesh.positions[static_cast<std::size_t>(i / 3)][i % 3] = bad;
            const Clipped c = clip(mesh, view);
            CHECK(!c.finite);
            CHECK(c.pieces.empty());
        }
    }
}

TEST_CASE("finite positions of any size are finite to the clipper") {
    const float most = std::numeric_limits<float>::max();
    CHECK(
        clip(triangles_of({{-most, -most, -2}, {most, 0, -2}, {0, most, most}}), view_from_origin())
            .finite);
}

// Corners that hurt: near the near plane and the eye plane, behind, far away.
glm::vec3 any_position(Random& random) {
    const double distance = random.one_in(3) ? 1 + random.real(-1e-3, 1e-3) : random.real(-4, 6);
    const double spread = std::pow(10.0, random.real(-1, 6));
    return {random.real(-spread, spread), random.real(-spread, spread), -distance};
}

// How far the window position of a corner may be off: it is snapped, and its barycentrics leave a
// point that is the more uncertain the nearer it is to the eye.
struct Slack {
    double pixels, relative;
};
Slack slack(const glm::dvec4 (&clip_of)[3], const glm::dvec3& b, const glm::dvec4& p,
            const View& view) {
    double error[4] = {0, 0, 0, 0};
    for (int i = 0; i < 3; ++i) {
        for (int k = 0; k < 4; ++k) {
            error[k] += 0x1p-50 * std::abs(b[i] * clip_of[i][k]) + 1e-30;
        }
    }
    const double relative = error[3] / p.w + 1e-6;
    const double off = 0.5 * view.width * (error[0] / p.w + std::abs(p.x / p.w) * relative) +
                       0.5 * view.height * (error[1] / p.w + std::abs(p.y / p.w) * relative);
    return {1.0 / 256 + off, relative + error[2] / p.w};
}

TEST_CASE("the pieces' barycentrics reproduce the mesh, within near plane and guard band") {
    const View view = view_from_origin(640, 200);
    int pieces = 0;
    std::size_t most = 0;
    for (std::uint64_t seed = 1; seed <= 20000; ++seed) {
        CAPTURE(seed);
        Random random(seed);
        const Mesh mesh =
            triangles_of({any_position(random), any_position(random), any_position(random)});
        glm::dvec4 corner[3];
        for (std::size_t i = 0; i < 3; ++i) {
            const glm::dvec3 p(mesh.positions[i]);
            corner[i] = clip_position(view.clip_from_world, p.x, p.y, p.z);
        }
        const Clipped c = clip(mesh, view);
        REQUIRE(c.finite);
        most = std::max(most, c.pieces.size());
        for (const ScreenTriangle& piece : c.pieces) {
            ++pieces;
            bool good = piece.clipped && piece.source == 0;
            for (int i = 0; i < 3; ++i) {
                const glm::dvec3 b(piece.barycentric[i]);
                const ScreenVertex& v = piece.v[i];
                const glm::dvec4 p = b.x * corner[0] + b.y * corner[1] + b.z * corner[2];
                const WindowPosition<double> w = window_position(p, view);
                const Slack s = slack(corner, b, p, view);
                good = good && std::abs(b.x + b.y + b.z - 1) < 1e-6 &&
                       std::min({b.x, b.y, b.z}) >= 0 && std::abs(v.x / 256.0 - w.x) <= s.pixels &&
                       std::abs(v.y / 256.0 - w.y) <= s.pixels &&
                       std::abs(v.z - w.z) <= s.relative * (1 + std::abs(w.z)) &&
                       std::abs(v.inverse_w - w.inverse_w) <= s.relative * w.inverse_w &&
                       std::max(std::abs(v.x), std::abs(v.y)) <= guard_band * subpixel_one &&
                       v.z <= 1 + 1e-6 && v.inverse_w > 0;
            }
            CHECK(good);
        }
    }
    CHECK(pieces > 10000);
    CHECK(most >= 4);
    CHECK(most <= 7);
}

// What a picture can be drawn of, whatever is asked for.
bool is_placed(const Clipped& c) {
    bool good = c.pieces.size() <= 7;
    for (const ScreenTriangle& piece : c.pieces) {
        for (const ScreenVertex& v : piece.v) {
            good = good && std::max(std::abs(v.x), std::abs(v.y)) <= guard_band * subpixel_one &&
                   v.z <= 1 && v.z >= -0.01F && v.inverse_w > 0 && std::isfinite(v.inverse_w);
        }
    }
    return good;
}

TEST_CASE("however large the numbers, pieces stay before the eye and in the guard band") {
    int clipped = 0;
    for (std::uint64_t seed = 1; seed <= 20000; ++seed) {
        CAPTURE(seed);
        Random random(seed);
        const double size = std::pow(10.0, random.real(0, 37));
        const auto far_away = [&] {
            return glm::vec3(random.real(-size, size), random.real(-1, 1) * (size > 1e6 ? 1 : size),
                             random.real(-size, size));
        };
        const Camera camera{.eye = {0.3F, 2, 0.2F},
                            .target = {static_cast<float>(random.real(-1, 1)), 1.5F, -1},
                            .near = 0.1F,
                            .far = 1e8F};
        const View view{clip_from_world(camera, 1.0F), 1 + static_cast<int>(seed % 16384), 300};
        const Clipped c = clip(triangles_of({far_away(), far_away(), far_away()}), view);
        clipped += c.pieces.empty() ? 0 : 1;
        CHECK(is_placed(c));
    }
    CHECK(clipped > 5000);
}

TEST_CASE("a sliver as thin as rounding leaves a plane once") {
    View view{glm::mat4(1.0F), 6440, 14531};
    view.clip_from_world[0] = {-0x1.14cd5cp+2F, -0x1.632734p+0F, -0x1.4a7dd8p-11F, 0x1.426c46p-1F};
    view.clip_from_world[1] = {0, 0x1.3bec04p+1F, -0x1.338f44p-11F, 0x1.2c0d04p-1F};
    view.clip_from_world[2] = {0x1.55da92p+2F, -0x1.1f922p+0F, -0x1.0b9a22p-11F, 0x1.0511ap-1F};
    view.clip_from_world[3] = {0, 0, 0x1.9a029p-4F, 0};
    CHECK(is_placed(clip(triangles_of({{0x1.94b8bep-47F, 0x1.376922p+93F, 0x1.4db47cp-28F},
                                       {-0x1.6708eep+95F, 0x1.a5dbaap+77F, 0x1.5758e4p-96F},
                                       {0x1.3af412p+16F, -0x1.35d1fap-4F, 0x1.4c5416p-49F}}),
                         view)));
}

std::vector<std::pair<std::int32_t, std::int32_t>> corners_of(const Clipped& c) {
    std::vector<std::pair<std::int32_t, std::int32_t>> corners;
    for (const ScreenTriangle& piece : c.pieces) {
        for (const ScreenVertex& v : piece.v) {
            corners.emplace_back(v.x, v.y);
        }
    }
    std::sort(corners.begin(), corners.end());
    corners.erase(std::unique(corners.begin(), corners.end()), corners.end());
    return corners;
}

TEST_CASE("a vertex that has a place keeps it, at the near plane too: neighbours stay joined") {
    int beyond = 0;  // by what clipping computes
    for (std::uint64_t seed = 1; seed <= 20000; ++seed) {
        CAPTURE(seed);
        Random random(seed);
        const auto number = [&](double most) {
            return static_cast<float>(random.real(-most, most));
        };
        const Camera camera{.eye = {number(5), number(5), number(5)},
                            .target = {number(5), number(5), number(5)},
                            .near = 0.1F};
        const View view{clip_from_world(camera, 1.0F), 512, 512};
        const glm::vec3 forward = normalize(camera.target - camera.eye);
        const glm::vec3 aside = normalize(cross(forward, camera.up));
        const glm::vec3 at_near = camera.eye + 0.1F * forward + number(0.03) * aside;
        const Mesh mesh = triangles_of(
            {at_near, at_near + 0.4F * forward, at_near - 0.03F * forward + number(0.1) * aside});
        const VertexBuffer vertices = transformed(mesh, view);
        if (vertices[0].x == needs_clipping || vertices[1].x == needs_clipping) {
            continue;
        }
        const glm::dvec3 p(at_near);
        const glm::dvec4 exact = clip_position(view.clip_from_world, p.x, p.y, p.z);
        beyond += exact.w < exact.z ? 1 : 0;
        const auto corners = corners_of(clip(mesh, view));
        for (const ScreenVertex& v : {vertices[0], vertices[1]}) {
            CHECK(std::count(corners.begin(), corners.end(), std::pair(v.x, v.y)) == 1);
        }
    }
    CHECK(beyond > 500);
}

TEST_CASE("an edge is cut at the same point from both its sides") {
    const View view = view_from_origin();
    const glm::vec3 front(0.3F, -0.2F, -2.1F);
    const glm::vec3 back(0.7F, 0.5F, 0.4F);
    for (int turn = 0; turn < 3; ++turn) {
        // Two triangles on either side of the edge front - back, which runs the other way in each.
        Mesh mesh = triangles_of({front, back, {-3, 0.1F, -2}, back, front, {3, 0.3F, 0.5F}});
        glm::uvec3& t = mesh.triangles[1];
        for (int i = 0; i < turn; ++i) {
            t = {t.y, t.z, t.x};
        }
        const auto left = corners_of(clip(mesh, view, 0));
        const auto right = corners_of(clip(mesh, view, 1));
        std::vector<std::pair<std::int32_t, std::int32_t>> shared;
        std::set_intersection(left.begin(), left.end(), right.begin(), right.end(),
                              std::back_inserter(shared));
        CHECK(shared.size() == 2);  // front, and the cut
    }
}

}  // namespace
}  // namespace glint
