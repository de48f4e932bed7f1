#include "framework/scene/camera.hpp"

#include "framework/math/error.hpp"

#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/trigonometric.hpp>

#include <algorithm>
#include <cmath>

namespace glint {
namespace {

bool finite(const glm::vec3& v) {
    return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

void check(const Camera& c) {
    if (!finite(c.eye) || !finite(c.target) || !finite(c.up)) {
        throw Error("camera: eye, target and up must be finite");
    }
    if (!(c.fov_degrees > 0 && c.fov_degrees < 180)) {
        throw Error("camera: the field of view must lie between 0 and 180 degrees");
    }
    if (!(c.near > 0 && c.near < c.far && std::isfinite(c.far))) {
        throw Error("camera: 0 < near < far must hold");
    }
    const glm::dvec3 forward = glm::dvec3(c.target) - glm::dvec3(c.eye);
    if (length(forward) == 0) {
        throw Error("camera: eye and target are the same point");
    }
    if (length(cross(normalize(forward), glm::dvec3(c.up))) < 1e-6 * length(glm::dvec3(c.up)) ||
        c.up == glm::vec3(0)) {
        throw Error("camera: up points along the view direction");
    }
}

struct Sphere {
    glm::vec3 centre;
    float radius;
};

Sphere sphere_about(const Mesh& mesh) {
    const Bounds box = bounds(mesh);
    const float radius = 0.5F * length(box.high - box.low);
    if (!(radius > 0)) {
        throw Error("camera: the mesh has no extent to frame");
    }
    return {0.5F * (box.low + box.high), radius};
}

}  // namespace

glm::mat4 clip_from_world(const Camera& camera, float aspect) {
    check(camera);
    if (!(aspect > 0 && std::isfinite(aspect))) {
        throw Error("camera: the aspect, width over height, must be above 0");
    }
    const double n = camera.near;
    const double f = camera.far;
    const double cotangent = 1.0 / std::tan(glm::radians(double{camera.fov_degrees}) / 2);
    glm::dmat4 clip_from_eye(0.0);
    clip_from_eye[0][0] = cotangent / double{aspect};
    clip_from_eye[1][1] = cotangent;
    clip_from_eye[2][2] = n / (f - n);
    clip_from_eye[3][2] = n * f / (f - n);
    clip_from_eye[2][3] = -1;
    const glm::dmat4 eye_from_world =
        glm::lookAt(glm::dvec3(camera.eye), glm::dvec3(camera.target), glm::dvec3(camera.up));
    const glm::mat4 rounded(clip_from_eye * eye_from_world);
    return rounded;
}

Camera around(const Mesh& mesh, Camera camera) {
    const auto [centre, radius] = sphere_about(mesh);
    const float distance = length(camera.eye - centre);
    camera.near = std::max(distance - 1.1F * radius, 0.01F * radius);
    camera.far = distance + 1.1F * radius;
    if (!(camera.near < camera.far)) {
        throw Error("camera: the eye is too far away to see the mesh; move it nearer");
    }
    return camera;
}

Camera frame(const Mesh& mesh, Camera camera, float aspect) {
    const auto [centre, radius] = sphere_about(mesh);
    const float half = glm::radians(camera.fov_degrees) / 2;
    const float narrower = std::min(half, std::atan(std::tan(half) * aspect));
    const glm::vec3 backwards = normalize_or(camera.eye - camera.target, glm::vec3(0, 0, 1));
    camera.target = centre;
    camera.eye = centre + radius / std::sin(narrower) * backwards;
    return around(mesh, camera);
}

}  // namespace glint
