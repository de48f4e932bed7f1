#include "framework/app/window_camera.hpp"

#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include <algorithm>
#include <cmath>

namespace glint {
namespace {

constexpr float key_angle = glm::radians(5.0F);
constexpr float key_pan = 0.05F;  // of the picture's height
constexpr float key_zoom = 1.1F;

}  // namespace

Camera orbit(Camera camera, float right, float up) {
    constexpr float highest = glm::radians(89.8F);
    const glm::vec3 pole = normalize(camera.up);
    const glm::vec3 out = camera.eye - camera.target;
    const float distance = length(out);
    const float height = dot(out, pole) / distance;  // sine of the elevation
    const float elevation =
        std::clamp(std::asin(std::clamp(height, -1.0F, 1.0F)) + up, -highest, highest);
    const glm::vec3 front = normalize(out - dot(out, pole) * pole);
    const glm::vec3 side = cross(pole, front);
    const glm::vec3 flat = std::cos(right) * front + std::sin(right) * side;
    camera.eye =
        camera.target + distance * (std::cos(elevation) * flat + std::sin(elevation) * pole);
    return camera;
}

Camera pan(Camera camera, float x, float y, int height) {
    const glm::vec3 forward = camera.target - camera.eye;
    const glm::vec3 right = normalize(cross(forward, camera.up));
    const glm::vec3 up = normalize(cross(right, forward));
    const float pixel = 2.0F * std::tan(glm::radians(camera.fov_degrees) / 2) * length(forward) /
                        static_cast<float>(height);
    const glm::vec3 way = pixel * (y * up - x * right);
    camera.eye += way;
    camera.target += way;
    return camera;
}

Camera zoom(Camera camera, float factor, float usual) {
    const glm::vec3 out = camera.eye - camera.target;
    const float distance = std::clamp(factor * length(out), usual / 1000.0F, usual * 1000.0F);
    camera.eye = camera.target + distance * normalize(out);
    return camera;
}

Camera with_depth_range(Camera camera, const Mesh& mesh, const Options& options) {
    if (mesh.positions.empty()) {
        return camera;
    }
    const Bounds box = bounds(mesh);
    const float extent = distance(box.low, box.high);
    if (!(extent > 0) || !std::isfinite(extent)) {
        return camera;
    }
    camera = around(mesh, camera);
    camera.near = std::min(camera.near, 0.05F * distance(camera.eye, camera.target));
    camera.near = options.near.value_or(camera.near);
    camera.far = options.far.value_or(std::max(camera.far, 2.0F * camera.near));
    if (!options.near) {
        camera.near = std::min(camera.near, 0.5F * camera.far);
    }
    return camera;
}

Camera steered(const Camera& camera, Action action, float usual, int height) {
    const float step = key_pan * static_cast<float>(height);
    switch (action) {
        case Action::orbit_left:
            return orbit(camera, -key_angle, 0);
        case Action::orbit_right:
            return orbit(camera, key_angle, 0);
        case Action::orbit_up:
            return orbit(camera, 0, key_angle);
        case Action::orbit_down:
            return orbit(camera, 0, -key_angle);
        case Action::pan_left:
            return pan(camera, -step, 0, height);
        case Action::pan_right:
            return pan(camera, step, 0, height);
        case Action::pan_up:
            return pan(camera, 0, -step, height);
        case Action::pan_down:
            return pan(camera, 0, step, height);
        case Action::zoom_in:
            return zoom(camera, 1.0F / key_zoom, usual);
        case Action::zoom_out:
            return zoom(camera, key_zoom, usual);
        default:
            return camera;
    }
}

}  // namespace glint
