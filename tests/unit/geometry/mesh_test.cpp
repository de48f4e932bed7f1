#include "framework/geometry/mesh.hpp"

#include "framework/geometry/shapes.hpp"
#include "framework/math/error.hpp"
#include "tests/unit/geometry/mesh_checks.hpp"

#include <doctest/doctest.h>

namespace glint {
namespace {

// Columns: where the axes go, then the origin.
const glm::mat4 stretched({2, 0, 0, 0}, {0, 1, 0, 0}, {0, 0.5F, 1, 0}, {1, 2, 3, 1});
const glm::mat4 mirrored({-1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 1, 0}, {0, 0, 0, 1});

TEST_CASE("a transformed plane keeps its normals perpendicular") {
    const Mesh mesh = transform(plane(2, 2, 1, 1), stretched);
    CHECK(mesh.positions[0] == glm::vec3(-1, 2.5, 4));
    for (const glm::vec3& n : mesh.normals) {
        CHECK(std::abs(dot(n, mesh.positions[1] - mesh.positions[0])) < 1e-6F);
        CHECK(std::abs(dot(n, mesh.positions[2] - mesh.positions[0])) < 1e-6F);
    }
    CHECK(least_agreement(mesh) > 0.999999);
    CHECK(is_valid(mesh));
}

TEST_CASE("a mirrored solid still faces outwards") {
    const Mesh mesh = transform(torus(1.0F, 0.4F, 24, 12), mirrored);
    CHECK(volume(mesh) > 0.0);
    CHECK(least_agreement(mesh) > 0.9);
    CHECK(topology(mesh).closed());
}

TEST_CASE("a small scale keeps normals") {
    const Mesh mesh = transform(sphere(1.0F, 12, 6), glm::mat4(glm::mat3(1e-9F)));
    CHECK(is_valid(mesh));
    CHECK(least_agreement(mesh) > 0.8);
}

TEST_CASE("only affine, invertible matrices transform") {
    const Mesh mesh = box({1, 1, 1});
    CHECK_THROWS_AS(transform(mesh, glm::mat4(0.0F)), Error);
    CHECK_THROWS_AS(transform(mesh, glm::mat4(glm::mat3(NAN))), Error);
    glm::mat4 flat(1.0F);
    flat[1][1] = 0.0F;
    CHECK_THROWS_AS(transform(mesh, flat), Error);
    glm::mat4 perspective(1.0F);
    perspective[2][3] = -1.0F;
    CHECK_THROWS_AS(transform(mesh, perspective), Error);
}

TEST_CASE("append shifts indices and gives its material to the new triangles") {
    Mesh mesh = box({1, 1, 1});
    const Mesh ball = sphere(1.0F, 8, 4);
    append(mesh, ball);
    CHECK(mesh.materials.empty());
    append(mesh, ball, 3);
    CHECK(is_valid(mesh));
    CHECK(mesh.triangles.size() == 12 + 48 + 48);
    CHECK(mesh.materials[59] == 0);
    CHECK(mesh.materials[60] == 3);
    CHECK(mesh.triangles.back() ==
          ball.triangles.back() +
              static_cast<std::uint32_t>(mesh.positions.size() - ball.positions.size()));
    CHECK(mesh.positions.back() == ball.positions.back());
}

TEST_CASE("append fills missing texture coordinates, either way") {
    Mesh bare = box({1, 1, 1});
    bare.uvs.clear();
    Mesh first = bare;
    append(first, box({1, 1, 1}));
    CHECK(is_valid(first));
    CHECK(first.uvs[0] == glm::vec2(0));
    CHECK(first.uvs.back() == glm::vec2(1, 1));
    Mesh second = box({1, 1, 1});
    append(second, bare);
    CHECK(is_valid(second));
    CHECK(second.uvs.back() == glm::vec2(0));
}

TEST_CASE("append to nothing and to itself") {
    Mesh mesh;
    append(mesh, box({1, 1, 1}));
    CHECK(is_valid(mesh));
    append(mesh, mesh, 1);
    CHECK(is_valid(mesh));
    CHECK(mesh.triangles.size() == 24);
    append(mesh, Mesh{});
    CHECK(mesh.triangles.size() == 24);
}

TEST_CASE("append does not mix meshes with and without normals") {
    Mesh mesh = box({1, 1, 1});
    Mesh bare = mesh;
    bare.normals.clear();
    CHECK_THROWS_AS(append(mesh, bare), Error);
}

TEST_CASE("bounds are those of the vertices") {
    const Bounds b = bounds(transform(
        box({2, 4, 6}), glm::mat4({1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 1, 0}, {1, 1, 1, 1})));
    CHECK(b.low == glm::vec3(0, -1, -2));
    CHECK(b.high == glm::vec3(2, 3, 4));
    CHECK_THROWS_AS(bounds(Mesh{}), Error);
}

}  // namespace
}  // namespace glint
