#include "framework/geometry/shapes.hpp"

#include "framework/math/error.hpp"
#include "tests/unit/geometry/mesh_checks.hpp"
#include "tests/worst.hpp"

#include <doctest/doctest.h>

#include <functional>
#include <limits>
#include <numbers>
#include <string>

namespace glint {
namespace {

constexpr double pi = std::numbers::pi;

// How far from the surface the middles of triangles are, at worst.
double worst_middle(const Mesh& mesh, const std::function<double(glm::dvec3)>& distance) {
    double worst = 0.0;
    for (const glm::uvec3& t : mesh.triangles) {
        const glm::dvec3 middle =
            (corner(mesh, t, 0) + corner(mesh, t, 1) + corner(mesh, t, 2)) / 3.0;
        worst = worse(worst, std::abs(distance(middle)));
    }
    return worst;
}

// The worst distance of a vertex from the surface, and of its normal from the gradient.
double worst_vertex(const Mesh& mesh, const std::function<double(glm::dvec3)>& distance) {
    double worst = 0.0;
    for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
        const glm::dvec3 p(mesh.positions[i]);
        glm::dvec3 gradient;
        for (int k = 0; k < 3; ++k) {
            glm::dvec3 step(0.0);
            step[k] = 1e-5;
            gradient[k] = (distance(p + step) - distance(p - step)) / 2e-5;
        }
        worst = worse(worst, std::abs(distance(p)));
        worst = worse(worst, length(gradient - glm::dvec3(mesh.normals[i])));
    }
    return worst;
}

double from_sphere(const glm::dvec3& p) {
    return length(p) - 2.0;
}

double from_torus(const glm::dvec3& p) {
    return std::hypot(std::hypot(p.x, p.z) - 2.0, p.y) - 0.5;
}

// A box of 3 x 2 x 1 rounded by 0.25.
double from_rounded_box(const glm::dvec3& p) {
    const glm::dvec3 out = glm::abs(p) - glm::dvec3(1.25, 0.75, 0.25);
    const double inside = std::min(std::max({out.x, out.y, out.z}), 0.0);
    return length(glm::max(out, glm::dvec3(0.0))) + inside - 0.25;
}

std::string message(const std::function<void()>& call) {
    try {
        call();
    } catch (const Error& e) {
        return e.what();
    }
    return "no error";
}

TEST_CASE("a sphere of 46 x 23 has 2,024 triangles") {
    const Mesh mesh = sphere(1.0F, 46, 23);
    CHECK(mesh.triangles.size() == 2024);
    CHECK(is_valid(mesh));
    CHECK(uses_every_vertex(mesh));
}

TEST_CASE("shapes are closed and face outwards") {
    struct Case {
        const char* name;
        Mesh mesh;
        int euler;
        double volume;  // of the smooth shape
    };
    const glm::vec2 cone[] = {{0, -1}, {1, -1}, {0, 2}};
    const glm::vec2 egg[] = {{0, -1}, {1.2F, -1}, {0.9F, 1.5F}, {0, 1.5F}};
    const Case cases[] = {
        {"sphere", sphere(2.0F, 96, 48), 2, 32.0 / 3.0 * pi},
        {"icosphere", icosphere(2.0F, 4), 2, 32.0 / 3.0 * pi},
        {"torus", torus(2.0F, 0.5F, 96, 48), 0, 2.0 * pi * pi * 2.0 * 0.25},
        {"knot", torus_knot({}, 512, 32), 0, 0.0},
        {"box", box({3, 2, 1}), 2, 6.0},
        // core, slabs, quarter cylinders, eighths of a sphere
        {"rounded box", rounded_box({3, 2, 1}, 0.25F, 12), 2,
         2.5 * 1.5 * 0.5 + 0.5 * (2.5 * 1.5 + 1.5 * 0.5 + 2.5 * 0.5) +
             pi * 0.0625 * (2.5 + 1.5 + 0.5) + 4.0 / 3.0 * pi / 64.0},
        {"cone", surface_of_revolution(cone, 96), 2, pi},
        {"egg", surface_of_revolution_bezier(egg, 48, 96), 2, 0.0},
    };
    for (const Case& c : cases) {
        CAPTURE(c.name);
        const Topology t = topology(c.mesh);
        CHECK(t.closed());
        CHECK(t.euler() == c.euler);
        CHECK(is_valid(c.mesh));
        CHECK(uses_every_vertex(c.mesh));
        CHECK(least_agreement(c.mesh) > 0.9);
        CHECK(texture_is_unmirrored(c.mesh));
        CHECK(volume(c.mesh) > 0.0);
        if (c.volume != 0.0) {
            CHECK(volume(c.mesh) == doctest::Approx(c.volume).epsilon(0.01));
        }
    }
}

TEST_CASE("odd and least numbers of steps close as well") {
    const Mesh meshes[] = {sphere(0.1F, 3, 2),
                           sphere(0.3F, 7, 5),
                           icosphere(1.0F, 0),
                           torus(1.0F, 0.3F, 3, 3),
                           torus(0.7F, 0.2F, 11, 13),
                           torus_knot({.p = 3, .q = 7}, 1000, 3),
                           torus_knot({.p = 1, .q = 1}, 50, 7),
                           box({1e-6F, 1.0F, 1e6F})};
    for (const Mesh& mesh : meshes) {
        CHECK(topology(mesh).closed());
        CHECK(uses_every_vertex(mesh));
        CHECK(volume(mesh) > 0.0);
    }
    for (int steps = 1; steps < 40; ++steps) {
        CAPTURE(steps);
        CHECK(topology(rounded_box({1.0F, 0.7F, 0.9F}, 0.0371F * 7.0F, steps)).closed());
    }
}

TEST_CASE("vertices lie on the surface and normals are its gradient") {
    CHECK(worst_vertex(sphere(2.0F, 46, 23), from_sphere) < 1e-6);
    CHECK(worst_vertex(icosphere(2.0F, 3), from_sphere) < 1e-6);
    CHECK(worst_vertex(torus(2.0F, 0.5F, 40, 24), from_torus) < 1e-6);
}

TEST_CASE("a rounded box is a box swept by a sphere") {
    const Mesh mesh = rounded_box({3, 2, 1}, 0.25F, 5);
    const glm::dvec3 core(1.25, 0.75, 0.25);
    for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
        const glm::dvec3 p(mesh.positions[i]);
        const glm::dvec3 nearest = glm::clamp(p, -core, core);
        REQUIRE(std::abs(from_rounded_box(p)) < 1e-6);
        REQUIRE(length((p - nearest) / 0.25 - glm::dvec3(mesh.normals[i])) < 1e-6);
    }
}

TEST_CASE("twice the steps, a quarter of the error") {
    using Make = std::function<Mesh(int)>;
    struct Case {
        const char* name;
        Make make;
        std::function<double(glm::dvec3)> distance;
    };
    const Case cases[] = {
        {"sphere", [](int n) { return sphere(2.0F, 2 * n, n); }, from_sphere},
        {"torus", [](int n) { return torus(2.0F, 0.5F, 2 * n, n); }, from_torus},
        {"rounded box",
         [](int n) {
             return rounded_box({3, 2, 1}, 0.25F, n);
         },
         from_rounded_box},
    };
    for (const Case& c : cases) {
        CAPTURE(c.name);
        const double coarse = worst_middle(c.make(16), c.distance);
        const double fine = worst_middle(c.make(32), c.distance);
        CHECK(coarse / fine > 3.6);
        CHECK(coarse / fine < 4.4);
    }
    const double coarse = worst_middle(icosphere(2.0F, 3), from_sphere);
    CHECK(coarse / worst_middle(icosphere(2.0F, 4), from_sphere) ==
          doctest::Approx(4.0).epsilon(0.1));
}

TEST_CASE("an icosphere is even") {
    const Mesh mesh = icosphere(1.0F, 4);
    CHECK(mesh.triangles.size() == 20 * 256);
    double least = 1.0;
    double most = 0.0;
    for (const glm::uvec3& t : mesh.triangles) {
        const double area = 0.5 * length(cross_product(mesh, t));
        least = std::min(least, area);
        most = std::max(most, area);
    }
    CHECK(most / least < 2.0);
}

TEST_CASE("an icosphere's texture is the sphere's, continued over the seam") {
    const Mesh mesh = icosphere(1.0F, 3);
    for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
        const glm::dvec3 p(mesh.positions[i]);
        const double u = 2.0 * pi * mesh.uvs[i].x;
        const double v = pi * mesh.uvs[i].y;
        const glm::dvec3 q(-std::sin(v) * std::sin(u), -std::cos(v), -std::sin(v) * std::cos(u));
        REQUIRE(length(p - q) < 1e-5);
    }
    for (const glm::uvec3& t : mesh.triangles) {
        const double u[] = {mesh.uvs[t.x].x, mesh.uvs[t.y].x, mesh.uvs[t.z].x};
        const auto [low, high] = std::minmax_element(std::begin(u), std::end(u));
        REQUIRE(*high - *low < 0.5);
    }
}

TEST_CASE("a knot's tube has its radius everywhere") {
    const TorusKnot knot{.p = 2, .q = 3, .major = 1.0F, .minor = 0.4F, .tube = 0.15F};
    const int segments = 300;
    const int sides = 16;
    const Mesh mesh = torus_knot(knot, segments, sides);
    CHECK(mesh.triangles.size() == 2 * segments * sides);
    for (int column = 0; column <= segments; ++column) {
        const double t = 2.0 * pi * column / segments;
        const double distance = 1.0 + 0.4F * std::cos(3.0 * t);
        const glm::dvec3 centre(-distance * std::sin(2.0 * t), 0.4F * std::sin(3.0 * t),
                                -distance * std::cos(2.0 * t));
        for (int row = 0; row <= sides; ++row) {
            const std::ptrdiff_t i = row * std::ptrdiff_t{segments + 1} + column;
            const glm::dvec3 spoke = glm::dvec3(mesh.positions.begin()[i]) - centre;
            REQUIRE(length(spoke) == doctest::Approx(0.15).epsilon(1e-5));
            REQUIRE(length(spoke / 0.15 - glm::dvec3(mesh.normals.begin()[i])) < 1e-5);
        }
    }
}

TEST_CASE("a plane faces up and has its texture upright") {
    const Mesh mesh = plane(4.0F, 2.0F, 3, 5);
    CHECK(mesh.triangles.size() == 30);
    CHECK(topology(mesh).borders == 1);
    CHECK(topology(mesh).euler() == 1);
    CHECK(least_agreement(mesh) > 1.0 - 2e-7);
    CHECK(mesh.normals.front() == glm::vec3(0, 1, 0));
    CHECK(mesh.positions.front() == glm::vec3(-2, 0, 1));
    CHECK(mesh.uvs.front() == glm::vec2(0, 0));
    CHECK(mesh.positions.back() == glm::vec3(2, 0, -1));
    CHECK(mesh.uvs.back() == glm::vec2(1, 1));
}

TEST_CASE("textures fill 0 to 1") {
    const glm::vec2 profile[] = {{1, 0}, {1, 1}, {2, 2}};
    const Mesh meshes[] = {sphere(1.0F, 8, 4),
                           torus(1.0F, 0.5F, 8, 4),
                           torus_knot({}, 64, 8),
                           plane(1, 1, 2, 2),
                           box({1, 2, 3}),
                           rounded_box({1, 2, 3}, 0.1F, 3),
                           surface_of_revolution(profile, 8)};
    for (const Mesh& mesh : meshes) {
        CHECK(uvs_within(mesh, 0.0F, 1.0F));
        glm::vec2 low(1.0F);
        glm::vec2 high(0.0F);
        for (const glm::vec2& uv : mesh.uvs) {
            low = glm::min(low, uv);
            high = glm::max(high, uv);
        }
        CHECK(low == glm::vec2(0.0F));
        CHECK(high == glm::vec2(1.0F));
    }
}

TEST_CASE("profiles: a cylinder's wall, a cone's slope, a Bezier curve's derivative") {
    const glm::vec2 wall[] = {{1.5F, 0}, {1.5F, 2}};
    const Mesh cylinder = surface_of_revolution(wall, 12);
    CHECK(topology(cylinder).borders == 2);
    for (std::size_t i = 0; i < cylinder.positions.size(); ++i) {
        const glm::vec3 p = cylinder.positions[i];
        CHECK(length(cylinder.normals[i] - glm::vec3(p.x, 0, p.z) / 1.5F) < 1e-6F);
    }
    const glm::vec2 slope[] = {{1, 0}, {0, 1}};
    for (const glm::vec3& n : surface_of_revolution(slope, 12).normals) {
        CHECK(n.y == doctest::Approx(std::sqrt(0.5)));
    }
    // x = 1 + t, y = t^2
    const glm::vec2 parabola[] = {{1, 0}, {4.0F / 3, 0}, {5.0F / 3, 1.0F / 3}, {2, 1}};
    const Mesh bowl = surface_of_revolution_bezier(parabola, 10, 12);
    for (std::size_t i = 0; i < bowl.positions.size(); ++i) {
        const glm::dvec3 p(bowl.positions[i]);
        const double t = std::hypot(p.x, p.z) - 1.0;
        CHECK(p.y == doctest::Approx(t * t).epsilon(1e-5));
        CHECK(bowl.normals[i].y == doctest::Approx(-1.0 / std::hypot(1.0, 2.0 * t)));
    }
}

TEST_CASE("a Bezier profile whose control points coincide at the ends still has normals") {
    const glm::vec2 stuck[] = {{0, 0}, {0, 0}, {1, 1}, {1, 1}};
    const Mesh mesh = surface_of_revolution_bezier(stuck, 4, 6);
    CHECK(is_valid(mesh));
    for (const glm::vec3& n : mesh.normals) {
        CHECK(n.y == doctest::Approx(-std::sqrt(0.5)));
    }
}

TEST_CASE("a parameter out of range is an error that names it") {
    const float nan = std::numeric_limits<float>::quiet_NaN();
    CHECK(message([] { sphere(1.0F, 2, 8); }) == "sphere: segments must be 3 to 4096, not 2");
    CHECK(message([&] { sphere(nan, 8, 8); }) == "sphere: radius must be 1e-6 to 1e6, not nan");
    CHECK_THROWS_AS(sphere(0.0F, 8, 8), Error);
    CHECK_THROWS_AS(sphere(2e6F, 8, 8), Error);
    CHECK_THROWS_AS(sphere(1.0F, 8, 1), Error);
    CHECK_THROWS_AS(sphere(1.0F, 4097, 8), Error);
    CHECK_THROWS_AS(icosphere(1.0F, -1), Error);
    CHECK_THROWS_AS(icosphere(1.0F, 9), Error);
    CHECK_THROWS_AS(torus(1.0F, 1.0F, 8, 8), Error);
    CHECK_THROWS_AS(torus(1.0F, 0.5F, 2, 8), Error);
    CHECK_THROWS_AS(torus(1.0F, 0.5F, 8, 2), Error);
    CHECK_THROWS_AS(torus_knot({.p = 2, .q = 4}, 64, 8), Error);
    CHECK_THROWS_AS(torus_knot({.p = 0}, 64, 8), Error);
    CHECK_THROWS_AS(torus_knot({.tube = 0.5F}, 64, 8), Error);
    CHECK_THROWS_AS(plane(1, 1, 0, 1), Error);
    CHECK_THROWS_AS(plane(-1, 1, 1, 1), Error);
    CHECK_THROWS_AS(box({1, 0, 1}), Error);
    CHECK_THROWS_AS(rounded_box({1, 2, 3}, 0.5F, 4), Error);
    CHECK_THROWS_AS(rounded_box({1, 2, 3}, 0.1F, 0), Error);
    CHECK_THROWS_AS(teapot(1), Error);
    CHECK_THROWS_AS(teapot(257), Error);
}

TEST_CASE("a profile without surface is an error") {
    using Points = std::vector<glm::vec2>;
    CHECK_THROWS_AS(surface_of_revolution(Points{{1, 0}}, 8), Error);
    CHECK_THROWS_AS(surface_of_revolution(Points{{1, 0}, {1, 0}}, 8), Error);
    CHECK_THROWS_AS(surface_of_revolution(Points{{0, 0}, {0, 1}}, 8), Error);
    CHECK_THROWS_AS(surface_of_revolution(Points{{1, 0}, {-1, 1}}, 8), Error);
    CHECK_THROWS_AS(surface_of_revolution(Points{{1, 0}, {NAN, 1}}, 8), Error);
    CHECK_THROWS_AS(surface_of_revolution(Points{{1, 0}, {1, 1}}, 2), Error);
    CHECK_THROWS_AS(surface_of_revolution_bezier(Points{{1, 0}, {1, 1}, {1, 2}}, 4, 8), Error);
    CHECK_THROWS_AS(surface_of_revolution_bezier(Points(4, {0, 1}), 4, 8), Error);
    CHECK_THROWS_AS(surface_of_revolution_bezier(Points(4, {1, 1}), 4, 8), Error);
    CHECK_THROWS_AS(surface_of_revolution_bezier(Points{{1, 0}, {1, 1}, {1, 2}, {1, 3}}, 1, 8),
                    Error);
    // goes forth and back: a cusp in the middle
    CHECK_THROWS_AS(surface_of_revolution_bezier(Points{{1, 0}, {1, 1}, {1, 1}, {1, 0}}, 4, 8),
                    Error);
}

}  // namespace
}  // namespace glint
