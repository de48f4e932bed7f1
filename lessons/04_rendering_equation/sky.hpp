// What is around a surface in lesson 4: light from all directions, and directions to sum it by.
#pragma once

#include "framework/math/vec.hpp"

#include <cmath>
#include <numbers>
#include <vector>

namespace glint {

// So many directions, spread evenly over the sphere: on a spiral from pole to pole, in equal steps
// of height, each turned on by the golden angle.
inline std::vector<glm::vec3> sphere_directions(int count) {
    std::vector<glm::vec3> all;
    for (int i = 0; i < count; ++i) {
        const double height = 1 - (2 * i + 1.0) / count;
        const double across = std::sqrt(1 - height * height);
        const double azimuth = i * std::numbers::pi * (3 - std::sqrt(5.0));
        all.emplace_back(across * std::cos(azimuth), height, across * std::sin(azimuth));
    }
    return all;
}

// Radiance from above the horizon and from below it, alike in all directions there.
struct TwoTones {
    Rgb<float> above, below;

    Rgb<float> operator()(const glm::vec3& direction) const {
        return direction.y > 0 ? above : below;
    }
    // The integral of radiance times cosine over the hemisphere about N, in closed form. Flattened
    // by the cosine the hemisphere is a disk; the horizon cuts it along half an ellipse, so that
    // (1 + N.y)/2 of it are sky.
    template <Real T>
    Rgb<T> irradiance(const Vec3<T>& N) const {
        const T sky = T(0.5F) + T(0.5F) * N.y;
        return T(std::numbers::pi_v<float>) * mix(Rgb<T>(below), Rgb<T>(above), Rgb<T>(sky));
    }
};

// The picture's: blue above, earth below.
inline constexpr TwoTones sky_and_ground{{0.75F, 1.05F, 1.5F}, {0.32F, 0.13F, 0.04F}};

}  // namespace glint
