#include "framework/scene/camera.hpp"

#include "framework/geometry/shapes.hpp"
#include "framework/math/error.hpp"
#include "tests/oracle/random.hpp"
#include "tests/unit/refusal.hpp"

#include <doctest/doctest.h>
#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>

#include <cmath>
#include <limits>
#include <numbers>
#include <string>

namespace glint {
namespace {

using oracle::Random;

constexpr float infinity = std::numeric_limits<float>::infinity();
constexpr float nan = std::numeric_limits<float>::quiet_NaN();

glm::vec3 any_point(Random& random, double size) {
    return {random.real(-size, size), random.real(-size, size), random.real(-size, size)};
}

Camera any_camera(Random& random) {
    Camera c{.eye = any_point(random, 5),
             .target = any_point(random, 5),
             .up = any_point(random, 1),
             .fov_degrees = static_cast<float>(random.real(1, 170)),
             .near = static_cast<float>(std::pow(10.0, random.real(-3, 1)))};
    c.far = c.near * static_cast<float>(std::pow(10.0, random.real(0.1, 4)));
    return c;
}

TEST_CASE("x, y and w are those of glm, depth runs the other way") {
    Random random(1);
    for (int i = 0; i < 2000; ++i) {
        CAPTURE(i);
        const Camera c = any_camera(random);
        const auto aspect = static_cast<float>(std::pow(2.0, random.real(-3, 3)));
        const glm::dmat4 ours(clip_from_world(c, aspect));
        // glm's depth is -1 at near and 1 at far.
        const glm::dmat4 theirs =
            glm::perspective(glm::radians(double{c.fov_degrees}), double{aspect}, double{c.near},
                             double{c.far}) *
            glm::lookAt(glm::dvec3(c.eye), glm::dvec3(c.target), glm::dvec3(c.up));
        for (int column = 0; column < 4; ++column) {
            double row_size[4] = {0, 0, 0, 0};
            for (int row = 0; row < 4; ++row) {
                for (int k = 0; k < 4; ++k) {
                    row_size[row] = std::max(row_size[row], std::abs(theirs[k][row]));
                }
            }
            for (const int row : {0, 1, 3}) {
                CHECK(std::abs(ours[column][row] - theirs[column][row]) <= 1e-7 * row_size[row]);
            }
            const double reversed = (theirs[column][3] - theirs[column][2]) / 2;
            CHECK(std::abs(ours[column][2] - reversed) <= 1e-7 * (row_size[2] + row_size[3]));
        }
    }
}

TEST_CASE("depth is 1 at near and 0 at far and falls between") {
    const Camera c{.eye = {0, 0, 0}, .target = {0, 0, -1}, .near = 0.25F, .far = 1000};
    const glm::dmat4 m(clip_from_world(c, 1.5F));
    const auto depth = [&](double distance) {
        const glm::dvec4 p = m * glm::dvec4(0.1, -0.2, -distance, 1);
        CHECK(p.w == distance);
        return p.z / p.w;
    };
    CHECK(depth(0.25) == doctest::Approx(1).epsilon(1e-6));
    CHECK(std::abs(depth(1000)) < 1e-7);
    double previous = 2;
    for (double distance = 0.2; distance < 2000; distance *= 1.1) {
        const double n = c.near;
        const double f = c.far;
        CHECK(depth(distance) < previous);
        previous = depth(distance);
        CHECK(previous == doctest::Approx(n * (f - distance) / (distance * (f - n))).epsilon(1e-4));
    }
}

TEST_CASE("what makes no camera is an Error") {
    const struct {
        Camera camera;
        const char* word;
    } cases[] = {
        {{.eye = {1, 2, 3}, .target = {1, 2, 3}}, "same point"},
        {{.eye = {0, 0, 0}, .target = {0, 5, 0}}, "up"},
        {{.eye = {0, 0, 0}, .target = {0, -5, 0}}, "up"},
        {{.up = {0, 0, 0}}, "up"},
        {{.eye = {nan, 0, 0}}, "finite"},
        {{.target = {0, infinity, 0}}, "finite"},
        {{.up = {0, 0, -infinity}}, "finite"},
        {{.fov_degrees = 0}, "field of view"},
        {{.fov_degrees = 180}, "field of view"},
        {{.fov_degrees = -30}, "field of view"},
        {{.fov_degrees = nan}, "field of view"},
        {{.near = 0}, "near"},
        {{.near = -1}, "near"},
        {{.near = 1, .far = 1}, "near"},
        {{.near = 2, .far = 1}, "near"},
        {{.near = nan}, "near"},
        {{.far = nan}, "near"},
        {{.far = infinity}, "near"},
    };
    for (const auto& c : cases) {
        CAPTURE(c.word);
        const std::string why = refusal([&] { clip_from_world(c.camera, 1.0F); });
        CHECK(why.starts_with("camera: "));
        CHECK(why.find(c.word) != std::string::npos);
    }
    for (const float aspect : {0.0F, -1.0F, nan, infinity}) {
        CHECK(refusal([&] { clip_from_world({}, aspect); }).find("aspect") != std::string::npos);
    }
    CHECK_NOTHROW(clip_from_world({}, 1.0F));
}

// The largest |x/w| and |y/w| over the sphere about a mesh's bounds.
glm::dvec2 reach(const Camera& c, const Mesh& mesh, float aspect) {
    const Bounds box = bounds(mesh);
    const glm::dvec3 centre = 0.5 * (glm::dvec3(box.low) + glm::dvec3(box.high));
    const double radius = 0.5 * length(glm::dvec3(box.high) - glm::dvec3(box.low));
    const glm::dmat4 m(clip_from_world(c, aspect));
    glm::dvec2 most(0);
    for (int i = 0; i <= 60; ++i) {
        for (int k = 0; k < 120; ++k) {
            const double theta = std::numbers::pi * i / 60;
            const double phi = std::numbers::pi * k / 60;
            const glm::dvec3 n(std::sin(theta) * std::cos(phi), std::cos(theta),
                               std::sin(theta) * std::sin(phi));
            const glm::dvec4 p = m * glm::dvec4(centre + radius * n, 1);
            CHECK(p.w > 0);
            CHECK(p.z > 0);
            CHECK(p.z < p.w);
            most = max(most, abs(glm::dvec2(p) / p.w));
        }
    }
    return most;
}

TEST_CASE("frame() shows all of a mesh, as large as the window allows") {
    Random random(5);
    for (const float aspect : {0.1F, 0.5F, 1.0F, 1.7778F, 8.0F}) {
        for (const float fov : {5.0F, 45.0F, 120.0F}) {
            CAPTURE(aspect);
            CAPTURE(fov);
            glm::mat4 moved = glm::translate(glm::mat4(1.0F), any_point(random, 20));
            const Mesh mesh = transform(box({random.real(0.1, 9), 1, 2}), moved);
            Camera camera{.eye = any_point(random, 4), .target = any_point(random, 1)};
            camera.fov_degrees = fov;
            const Camera framed = frame(mesh, camera, aspect);
            const glm::dvec2 most = reach(framed, mesh, aspect);
            CHECK(std::max(most.x, most.y) <= 1.0001);
            CHECK(std::max(most.x, most.y) >= 0.98);
            CHECK(dot(normalize(camera.eye - camera.target),
                      normalize(framed.eye - framed.target)) > 0.99999F);
            CHECK(framed.fov_degrees == fov);
        }
    }
}

TEST_CASE("frame() of a camera in its own target looks from the front") {
    const Mesh mesh = box({1, 1, 1});
    const Camera framed = frame(mesh, {.eye = {1, 1, 1}, .target = {1, 1, 1}}, 1.0F);
    CHECK(framed.eye.z > 1);
    CHECK(reach(framed, mesh, 1.0F).x <= 1.0001);
}

TEST_CASE("around() keeps the eye and takes in all of the mesh, from outside or inside") {
    const Mesh mesh = box({2, 2, 2});
    const float radius = std::sqrt(3.0F);
    for (const float distance : {0.0F, 0.5F, 1.8F, 5.0F, 1000.0F}) {
        const Camera before{.eye = {distance, 0, 0}, .target = {distance, 0, -1}};
        const Camera c = around(mesh, before);
        CHECK(c.eye == before.eye);
        CHECK(c.target == before.target);
        CHECK(c.near > 0);
        CHECK(c.near <= std::max(distance - radius, 0.02F * radius));
        CHECK(c.far >= distance + radius);
        CHECK(c.far < 1.2F * (distance + 2 * radius));
    }
}

TEST_CASE("a mesh without extent cannot be framed") {
    Mesh point;
    point.positions = {{1, 1, 1}, {1, 1, 1}, {1, 1, 1}};
    point.triangles = {{0, 1, 2}};
    CHECK_THROWS_AS(frame(point, {}, 1.0F), Error);
    CHECK_THROWS_AS(around(point, {}), Error);
    point.positions[1].x = 2;
    CHECK_THROWS_AS(around(point, {.eye = {1e30F, 0, 0}}), Error);
    CHECK_THROWS_AS(frame(Mesh{}, {}, 1.0F), Error);
}

}  // namespace
}  // namespace glint
