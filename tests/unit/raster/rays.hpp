// Rays through the pixels of a camera's picture, in double and without matrices: what the pictures
// are held against.
#pragma once

#include "framework/scene/camera.hpp"

#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include <cmath>

namespace glint {

class Rays {
  public:
    Rays(const Camera& camera, int width, int height) : origin(camera.eye) {
        forward_ = normalize(glm::dvec3(camera.target) - origin);
        const glm::dvec3 right = normalize(cross(forward_, glm::dvec3(camera.up)));
        const glm::dvec3 up = cross(right, forward_);
        const double reach = std::tan(glm::radians(double{camera.fov_degrees}) / 2);
        per_column_ = right * (2 * reach / height);
        per_row_ = -up * (2 * reach / height);
        centre_ = {0.5 * width, 0.5 * height};
    }

    // From the eye through a window position; 1 long along the view direction.
    glm::dvec3 direction(double x, double y) const {
        return forward_ + per_column_ * (x - centre_.x) + per_row_ * (y - centre_.y);
    }

    // Window position of a point in front of the eye, and its distance along the view direction.
    glm::dvec3 project(const glm::dvec3& point) const {
        const glm::dvec3 way = point - origin;
        const double distance = dot(way, forward_);
        return {centre_.x + dot(way, per_column_) / dot(per_column_, per_column_) / distance,
                centre_.y + dot(way, per_row_) / dot(per_row_, per_row_) / distance, distance};
    }

    const glm::dvec3 origin;

  private:
    glm::dvec3 forward_{}, per_column_{}, per_row_{};
    glm::dvec2 centre_{};
};

// Distance along the view direction of a depth (1 at near, 0 at far).
inline double distance_of_depth(const Camera& camera, double depth) {
    const double n = camera.near;
    const double f = camera.far;
    return n * f / (n + depth * (f - n));
}

}  // namespace glint
