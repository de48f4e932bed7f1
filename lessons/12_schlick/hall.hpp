// The stage of lesson 12: strips of floor under a sky that is equally bright everywhere, so that
// the picture of a strip is its reflectance; the higher in the picture, the more grazing.
#pragma once

#include "framework/scene/scene.hpp"

namespace glint {

// From near the eye to the horizon, between two columns of the picture (tangents of the angle), as
// floor or as ceiling.
inline Mesh strip(float left, float right, bool ceiling) {
    const float y = ceiling ? 1.0F : -1.0F;
    Mesh m;
    for (const float depth : {1.0F, 4000.0F}) {
        m.positions.emplace_back(left * depth, y, -depth);
        m.positions.emplace_back(right * depth, y, -depth);
    }
    m.normals.assign(4, glm::vec3(0, -y, 0));
    m.triangles = {{0, 1, 3}, {0, 3, 2}};
    if (ceiling) {
        m.triangles = {{0, 3, 1}, {0, 2, 3}};
    }
    return m;
}

// As many strips in each of the groups, side by side. Material 2i is the floor of strip i, 2i + 1
// the ceiling above it.
inline Scene hall(int groups, int strips) {
    Scene s;
    s.materials.assign(static_cast<std::size_t>(2 * groups * strips), {});
    const float width = 0.1F;
    const float gap = 0.035F;
    const float all =
        width * static_cast<float>(groups * strips) + gap * static_cast<float>(groups - 1);
    for (int i = 0; i < groups * strips; ++i) {
        const int group = i / strips;
        const float left =
            width * static_cast<float>(i) + gap * static_cast<float>(group) - all / 2;
        append(s.mesh, strip(left, left + width, false), static_cast<std::uint16_t>(2 * i));
        append(s.mesh, strip(left, left + width, true), static_cast<std::uint16_t>(2 * i + 1));
    }
    s.camera = {.eye = glm::vec3(0), .target = {0, 0, -1}, .fov_degrees = 52, .far = 5000};
    s.background = Rgb<float>(0.010F, 0.012F, 0.016F);
    return s;
}

}  // namespace glint
