// Opponent colour spaces that FLIP sees in. XYZ is relative to the white of sRGB (D65): white is
// (1, 1, 1).
#pragma once

#include "framework/math/vec.hpp"

namespace glint {

// Linear RGB, 0..1, to XYZ. The rows follow from the primaries of ITU-R BT.709 and a white of
// x 0.31271, y 0.32902: that which FLIP's published numbers were made with.
inline glm::vec3 xyz_from_rgb(const Rgb<float>& rgb) {
    return {dot(glm::vec3(0.433895389F, 0.376242373F, 0.189862239F), rgb),
            dot(glm::vec3(0.212636822F, 0.715182982F, 0.072180196F), rgb),
            dot(glm::vec3(0.017752423F, 0.109465629F, 0.872781948F), rgb)};
}

inline Rgb<float> rgb_from_xyz(const glm::vec3& xyz) {
    return {dot(glm::vec3(3.080341988F, -1.537398969F, -0.542943019F), xyz),
            dot(glm::vec3(-0.921178396F, 1.875929984F, 0.045248412F), xyz),
            dot(glm::vec3(0.052881293F, -0.204011206F, 1.151129913F), xyz)};
}

// Lightness, red against green, yellow against blue: YCxCz of XYZ, CIELAB of its cube roots.
inline glm::vec3 opponent(const glm::vec3& v) {
    return {116.0F * v.y - 16.0F, 500.0F * (v.x - v.y), 200.0F * (v.y - v.z)};
}

inline glm::vec3 from_opponent(const glm::vec3& v) {
    const float y = (v.x + 16.0F) / 116.0F;
    return {y + v.y / 500.0F, y, y - v.z / 200.0F};
}

// CIE 15:2004: L* 0..100, a*, b*.
inline glm::vec3 cielab(const glm::vec3& xyz) {
    const auto root = [](float t) {
        constexpr float d = 6.0F / 29.0F;
        return t > d * d * d ? std::cbrt(t) : t / (3.0F * d * d) + 4.0F / 29.0F;
    };
    return opponent({root(xyz.x), root(xyz.y), root(xyz.z)});
}

// Lightness 0..1, green to red, blue to yellow, where equal distances look equal, to linear RGB
// (B. Ottosson, "A perceptual color space for image processing", 2020).
template <Real T>
Rgb<T> rgb_from_oklab(const Vec3<T>& lab) {
    const Vec3<T> root(dot(Vec3<T>(1.0, 0.3963377774, 0.2158037573), lab),
                       dot(Vec3<T>(1.0, -0.1055613458, -0.0638541728), lab),
                       dot(Vec3<T>(1.0, -0.0894841775, -1.2914855480), lab));
    const Vec3<T> cones = root * root * root;
    return {dot(Vec3<T>(4.0767416621, -3.3077115913, 0.2309699292), cones),
            dot(Vec3<T>(-1.2684380046, 2.6097574011, -0.3413193965), cones),
            dot(Vec3<T>(-0.0041960863, -0.7034186147, 1.7076147010), cones)};
}

}  // namespace glint
