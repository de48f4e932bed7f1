// Where light comes from, in radiometric units per primary of sRGB.
#pragma once

#include "framework/math/vec.hpp"

#include <vector>

namespace glint {

// From infinitely far: parallel rays.
struct DirectionalLight {
    glm::vec3 direction{0, 0, 1};  // towards the light, unit length
    Rgb<float> irradiance{1.0F};   // E on a surface that faces the light, W/m^2
};

struct PointLight {
    glm::vec3 position{0};
    Rgb<float> intensity{1.0F};  // I, W/sr; E = I / d^2 on a facing surface at distance d
};

struct Lighting {
    std::vector<DirectionalLight> directional;
    std::vector<PointLight> point;
    Rgb<float> ambient{0.0F};  // radiance La that comes from every direction alike, W/(m^2 sr)
};

// What reaches a point from one light.
template <Real T>
struct Incident {
    Vec3<T> direction;  // L, towards the light, unit length
    Rgb<T> irradiance;  // E on a surface that faces it
};

// Nearer than this (metres) a point light grows no brighter: 1/d^2 must stay finite.
inline constexpr float nearest_point_light = 1e-4F;

// Calls add(Incident<T>) for each light, in order. In the place of a point light L is the zero
// vector, so that N.L is 0 and nothing arrives.
template <Real T, class Add>
void for_each_light(const Lighting& lighting, const Vec3<T>& position, Add&& add) {
    for (const DirectionalLight& light : lighting.directional) {
        add(Incident<T>{Vec3<T>(light.direction), Rgb<T>(light.irradiance)});
    }
    for (const PointLight& light : lighting.point) {
        const Vec3<T> way = light.position - position;
        const T square = max(dot(way, way), T(nearest_point_light * nearest_point_light));
        add(Incident<T>{normalize_or(way, Vec3<T>(T(0.0F))), Rgb<T>(light.intensity) / square});
    }
}

}  // namespace glint
