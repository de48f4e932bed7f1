#include "framework/app/window_camera.hpp"

#include <doctest/doctest.h>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace glint {
namespace {

constexpr float quarter = std::numbers::pi_v<float> / 2;

Camera from_the_front() {
    return {.eye = {0, 0, 4}, .target = {0, 0, 0}, .fov_degrees = 40};
}

Camera askew() {
    return {.eye = {2, 3, 4}, .target = {0.5F, -1, 0.25F}, .up = {0.2F, 0.1F, 1}};
}

bool near(const glm::vec3& a, const glm::vec3& b, float tolerance = 1e-5F) {
    return distance(a, b) <= tolerance;
}

// Where a point of the world appears, in pixels.
glm::vec2 pixel_of(const Camera& camera, const glm::vec3& point, int width, int height) {
    const float aspect = static_cast<float>(width) / static_cast<float>(height);
    const glm::vec4 clip = clip_from_world(camera, aspect) * glm::vec4(point, 1);
    return {(clip.x / clip.w + 1) / 2 * static_cast<float>(width),
            (1 - clip.y / clip.w) / 2 * static_cast<float>(height)};
}

Mesh box_of(const glm::vec3& low, const glm::vec3& high) {
    Mesh mesh;
    for (int i = 0; i < 8; ++i) {
        mesh.positions.emplace_back((i & 1) != 0 ? high.x : low.x, (i & 2) != 0 ? high.y : low.y,
                                    (i & 4) != 0 ? high.z : low.z);
    }
    return mesh;
}

TEST_CASE("a quarter of an orbit to the right brings the eye to the right") {
    CHECK(near(orbit(from_the_front(), quarter, 0).eye, {4, 0, 0}));
    CHECK(near(orbit(from_the_front(), -quarter, 0).eye, {-4, 0, 0}));
    CHECK(near(orbit(from_the_front(), 0, quarter / 2).eye, {0, std::sqrt(8.0F), std::sqrt(8.0F)}));
}

TEST_CASE("an orbit keeps the target and the distance, whatever is up") {
    for (const float right : {-2.0F, 0.3F, 5.0F}) {
        for (const float up : {-0.4F, 0.0F, 0.6F}) {
            const Camera c = orbit(askew(), right, up);
            CHECK(c.target == askew().target);
            CHECK(length(c.eye - c.target) ==
                  doctest::Approx(length(askew().eye - askew().target)).epsilon(1e-5));
        }
    }
    CHECK(near(orbit(askew(), 4 * quarter, 0).eye, askew().eye));
}

TEST_CASE("an orbit stops short of the poles") {
    for (const Camera& start : {from_the_front(), askew()}) {
        for (const float up : {-100.0F, 100.0F}) {
            const Camera c = orbit(orbit(start, 0, up), 1, up);
            CHECK_NOTHROW(clip_from_world(c, 1.5F));
            const float height =
                dot(normalize(c.eye - c.target), normalize(c.up)) * (up > 0 ? 1.0F : -1.0F);
            CHECK(glm::degrees(std::asin(height)) > 89);
        }
    }
}

TEST_CASE("a pan moves what is at the target by as many pixels") {
    for (const Camera& start : {from_the_front(), askew()}) {
        const Camera c = pan(start, 30, -20, 400);
        const glm::vec2 before = pixel_of(start, start.target, 600, 400);
        const glm::vec2 after = pixel_of(c, start.target, 600, 400);
        CHECK(after.x - before.x == doctest::Approx(30).epsilon(1e-3));
        CHECK(after.y - before.y == doctest::Approx(-20).epsilon(1e-3));
        CHECK(near(c.eye - c.target, start.eye - start.target));
    }
}

TEST_CASE("a zoom changes the distance alone, within limits") {
    const Camera closer = zoom(askew(), 0.5F, 4);
    CHECK(closer.target == askew().target);
    CHECK(near(2.0F * (closer.eye - closer.target), askew().eye - askew().target));
    const auto far_from = [](const Camera& c) { return length(c.eye - c.target); };
    CHECK(far_from(zoom(from_the_front(), 1e-9F, 4)) == doctest::Approx(0.004));
    CHECK(far_from(zoom(from_the_front(), 1e9F, 4)) == doctest::Approx(4000));
}

TEST_CASE("near and far enclose the mesh wherever the eye goes") {
    const Mesh mesh = box_of({-1, -2, -3}, {2, 1, 0.5F});
    for (const float factor : {0.3F, 1.0F, 30.0F, 900.0F}) {
        for (const float right : {0.0F, 1.0F, 3.0F}) {
            const Camera c =
                with_depth_range(zoom(orbit(askew(), right, 0.2F), factor, 5), mesh, Options());
            CHECK_NOTHROW(clip_from_world(c, 1));
            const glm::vec3 forward = normalize(c.target - c.eye);
            for (const glm::vec3& p : mesh.positions) {
                const float depth = dot(p - c.eye, forward);
                CHECK(depth < c.far);
                CHECK((depth > c.near || depth < 0.05F * length(c.eye - c.target)));
            }
        }
    }
}

TEST_CASE("a near or far that the options name stays") {
    const Mesh mesh = box_of({-1, -1, -1}, {1, 1, 1});
    for (const float distance : {0.1F, 50.0F}) {
        Options only_near;
        only_near.near = distance;
        const Camera a = with_depth_range(from_the_front(), mesh, only_near);
        CHECK(a.near == distance);
        CHECK(a.far > a.near);
        Options only_far;
        only_far.far = distance;
        const Camera b = with_depth_range(from_the_front(), mesh, only_far);
        CHECK(b.far == distance);
        CHECK(b.near < b.far);
    }
}

TEST_CASE("a mesh without extent leaves near and far alone") {
    Mesh point;
    point.positions = {{1, 2, 3}};
    Mesh lost;
    lost.positions = {{NAN, 2, 3}, {1, 0, INFINITY}};
    for (const Mesh& mesh : {Mesh(), point, lost}) {
        const Camera c = with_depth_range(from_the_front(), mesh, Options());
        CHECK(c.near == from_the_front().near);
        CHECK(c.far == from_the_front().far);
    }
}

TEST_CASE("keys move the eye or the picture the way that they say") {
    const Camera start = from_the_front();
    const auto eye = [&](Action action) { return steered(start, action, 4, 400).eye; };
    CHECK(eye(Action::orbit_left).x < 0);
    CHECK(eye(Action::orbit_right).x > 0);
    CHECK(eye(Action::orbit_up).y > 0);
    CHECK(eye(Action::orbit_down).y < 0);
    CHECK(eye(Action::zoom_in).z < 4);
    CHECK(eye(Action::zoom_out).z > 4);
    const auto target = [&](Action action) {
        return pixel_of(steered(start, action, 4, 400), start.target, 400, 400);
    };
    CHECK(target(Action::pan_left).x == doctest::Approx(180));
    CHECK(target(Action::pan_right).x == doctest::Approx(220));
    CHECK(target(Action::pan_up).y == doctest::Approx(180));
    CHECK(target(Action::pan_down).y == doctest::Approx(220));
    CHECK(eye(Action::save) == start.eye);
}

}  // namespace
}  // namespace glint
