// The light of a photographer's studio, for surfaces that mirror it: radiance from every direction.
// All of it is grey, so that every colour in the picture is the material's.
#pragma once

#include "framework/math/vec.hpp"

#include <array>

namespace glint {

// A rectangle of light, infinitely far away, with a soft edge.
struct SoftBox {
    glm::vec3 towards, right, up;  // of unit length, at right angles to each other
    glm::vec2 half_size;           // half its width and height, as tangents of the angle
    float radiance;                // in its middle, W/(m^2 sr)
};

template <Real T>
T radiance_of(const SoftBox& box, const Vec3<T>& direction) {
    const float soft = 0.09F;
    const T depth = dot(Vec3<T>(box.towards), direction);
    const auto inside = [&](const glm::vec3& axis, float half) {
        const T from_edge = half * depth - abs(dot(Vec3<T>(axis), direction));
        const T t = clamp(from_edge / soft, T(0.0F), T(1.0F));
        return t * t * (3.0F - 2.0F * t);
    };
    return box.radiance * inside(box.right, box.half_size.x) * inside(box.up, box.half_size.y);
}

// In front, to the upper left and to the right, and high above.
inline constexpr std::array<SoftBox, 3> studio_lamps{{
    {.towards = {-0.5651184F, 0.5661186F, 0.6001257F},
     .right = {0.7280219F, 0, 0.6855539F},
     .up = {0.3881048F, 0.8243238F, -0.4121467F},
     .half_size = {0.42F, 0.42F},
     .radiance = 7},
    {.towards = {0.939997F, 0.0999997F, 0.3261989F},
     .right = {0.3278423F, 0, -0.9447325F},
     .up = {-0.0944729F, 0.9949875F, -0.0327841F},
     .half_size = {0.12F, 0.8F},
     .radiance = 4},
    {.towards = {0, 0.96F, -0.28F},
     .right = {1, 0, 0},
     .up = {0, 0.28F, 0.96F},
     .half_size = {1.2F, 0.18F},
     .radiance = 4},
}};

// What the viewer looks at along -z: a wall with a pool of light in its middle, a ceiling that
// grows brighter upwards, a dark floor, and the lamps.
struct Studio {
    float room = 1.0F;  // scales the light of ceiling and floor
    float pool = 1.0F;  // of the pool on the wall, which spheres show at their rims
    float lamps = 1.0F;

    template <Real T>
    Rgb<T> operator()(const Vec3<T>& direction) const {
        const T towards_pool = dot(Vec3<T>(glm::vec3(0, 0.12F, -0.9928F)), direction);
        const T c2 = towards_pool * max(towards_pool, T(0.0F));
        const T c8 = (c2 * c2) * (c2 * c2);
        const T above =
            room * (0.05F + 0.35F * max(direction.y, T(0.0F))) + 0.55F * pool * (c8 * c8);
        const T below = room * (0.03F + 0.12F * max(-direction.y, T(0.0F)));
        const T horizon = clamp(0.5F + direction.y * 16.0F, T(0.0F), T(1.0F));
        T light = below + (above - below) * horizon;
        for (const SoftBox& lamp : studio_lamps) {
            light += lamps * radiance_of(lamp, direction);
        }
        return Rgb<T>(light);
    }
};

}  // namespace glint
