#include "framework/geometry/bezier_patch.hpp"
#include "framework/geometry/shapes.hpp"
#include "tests/unit/geometry/mesh_checks.hpp"

#include <doctest/doctest.h>

namespace glint {
namespace {

// The worst distance from the middle of each cell's diagonal to the patch at the same u and v,
// which is at least as far as the patch's nearest point.
double worst_diagonal(int steps) {
    double worst = 0.0;
    for (const TeapotPatch& part : teapot_patches()) {
        for (int row = 0; row < steps; ++row) {
            for (int column = 0; column < steps; ++column) {
                const double u = static_cast<double>(column) / steps;
                const double v = static_cast<double>(row) / steps;
                const double h = 1.0 / steps;
                const glm::dvec3 middle =
                    0.5 * (point(part.patch, u, v) + point(part.patch, u + h, v + h));
                worst =
                    std::max(worst, length(middle - point(part.patch, u + 0.5 * h, v + 0.5 * h)));
            }
        }
    }
    return worst;
}

TEST_CASE("the teapot has its classical numbers") {
    const Mesh mesh = teapot(10);
    CHECK(mesh.triangles.size() == 6320);
    const Bounds box = bounds(mesh);
    CHECK(box.low == glm::vec3(-3.0F, 0.0F, -2.0F));
    CHECK(box.high.y == 3.15F);
    CHECK(box.high.z == 2.0F);
    CHECK(box.high.x == doctest::Approx(3.434).epsilon(1e-4));
}

TEST_CASE("a wrong control point shows in the sums of the triangles") {
    // expected: from another program's mesh of Newell's numbers, cut into the same cells
    const Mesh mesh = teapot(10);
    double area = 0.0;
    for (const glm::uvec3& t : mesh.triangles) {
        area += 0.5 * length(cross_product(mesh, t));
    }
    CHECK(area == doctest::Approx(52.66079).epsilon(1e-7));
    CHECK(volume(mesh) == doctest::Approx(25.770106).epsilon(1e-7));
}

TEST_CASE("the teapot is open where the original is") {
    for (const int steps : {2, 3, 7, 10, 16}) {
        CAPTURE(steps);
        const Mesh mesh = teapot(steps);
        const Topology t = topology(mesh);
        CHECK(t.oriented);
        CHECK_FALSE(t.collapsed);
        CHECK(t.borders == 6);      // rim, lid, both ends of spout and of handle
        CHECK(t.euler() == 2 - 1);  // two discs, two tubes; the handle touches the belly
        CHECK(uses_every_vertex(mesh));
    }
}

TEST_CASE("the teapot faces outwards with unit normals, at its poles too") {
    const Mesh mesh = teapot(16);
    CHECK(is_valid(mesh));
    CHECK(uvs_within(mesh, 0.0F, 1.0F));
    CHECK(texture_is_unmirrored(mesh));
    CHECK(least_agreement(mesh) > 0.6);
    CHECK(least_agreement(teapot(64)) > 0.97);
    CHECK(volume(mesh) > 0.0);
    int poles = 0;
    for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
        if (mesh.positions[i].x == 0.0F && mesh.positions[i].z == 0.0F) {
            const glm::vec3 up(0, mesh.positions[i].y == 0.0F ? -1 : 1, 0);
            CHECK(length(mesh.normals[i] - up) < 1e-7F);
            ++poles;
        }
    }
    CHECK(poles == 2 * 4 * 16);
}

TEST_CASE("patches meet smoothly") {
    const Mesh mesh = teapot(6);
    const std::vector<int> place = welded(mesh);
    std::map<int, glm::vec3> first;
    for (std::size_t i = 0; i < place.size(); ++i) {
        const auto at = first.try_emplace(place[i], mesh.normals[i]).first;
        if (mesh.positions[i] != glm::vec3(-2.0F, 0.9F, 0.0F)) {  // the handle's end on the belly
            CHECK(dot(at->second, mesh.normals[i]) > 0.9999F);
        }
    }
}

TEST_CASE("patch normals are perpendicular to differences along the patch") {
    for (const TeapotPatch& part : teapot_patches()) {
        for (const double u : {0.1, 0.5, 0.9}) {
            for (const double v : {0.001, 0.3, 0.7, 0.999}) {
                const glm::dvec3 n = normal(part.patch, u, v);
                const double h = 1e-6;
                const glm::dvec3 along_u =
                    (point(part.patch, u + h, v) - point(part.patch, u - h, v)) / (2.0 * h);
                const glm::dvec3 along_v =
                    (point(part.patch, u, v + h) - point(part.patch, u, v - h)) / (2.0 * h);
                CHECK(std::abs(dot(n, along_u)) < 1e-7);
                CHECK(std::abs(dot(n, along_v)) < 1e-7);
                CHECK(dot(n, cross(along_u, along_v)) > 0.0);
            }
        }
    }
}

TEST_CASE("twice the steps, a quarter of the error") {
    const double coarse = worst_diagonal(32);
    CHECK(coarse / worst_diagonal(64) == doctest::Approx(4.0).epsilon(0.05));
    CHECK(coarse < 2.1e-3);
}

}  // namespace
}  // namespace glint
