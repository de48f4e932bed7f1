// What lesson 15 shows: the same things on three shelves, each in a light of its own. Lesson 1's
// constants were tweaked on the first shelf until they pleased, and are not touched on the others.
#pragma once

#include "lessons/13_specular_colour/specular_colour.hpp"
#include "framework/scene/stages.hpp"
#include "framework/geometry/shapes.hpp"

#include <glm/gtc/matrix_transform.hpp>

#include <numbers>

namespace glint::shelves {

// Light from everywhere, as a sum over directions of equal solid angle.
template <class Radiance>
void surround(Lighting& l, Radiance radiance) {
    const int count = 320;
    const float solid_angle = 4 * std::numbers::pi_v<float> / count;
    for (int i = 0; i < count; ++i) {
        const float height =
            1 - (2 * static_cast<float>(i) + 1) / count;          // equal steps: equal areas
        const float azimuth = 2.399963F * static_cast<float>(i);  // the golden angle
        const float side = std::sqrt(1 - height * height);
        const glm::vec3 towards(side * std::cos(azimuth), height, side * std::sin(azimuth));
        l.directional.push_back({towards, radiance(towards) * solid_angle});
    }
}

// A lamp in a white room.
inline Lighting lamp() {
    Lighting l;
    l.directional = {{normalize(glm::vec3(-0.55F, 0.75F, 0.6F)), {2.5F, 2.42F, 2.3F}}};
    surround(l, [](const glm::vec3& towards) {
        return Rgb<float>(0.22F, 0.215F, 0.20F) * (1.0F + 0.7F * towards.y);
    });
    return l;
}

// A wide window to the left, the room dim.
inline Lighting window() {
    Lighting l;
    surround(l, [](const glm::vec3& towards) {
        const glm::vec3 middle = normalize(glm::vec3(-0.8F, 0.55F, -0.35F));
        const float inside = clamp((dot(towards, middle) - 0.8F) * 20.0F, 0.0F, 1.0F);
        return Rgb<float>(0.10F, 0.09F, 0.08F) + inside * Rgb<float>(3.6F, 3.9F, 4.2F);
    });
    return l;
}

// The sun low behind the things, a dusky sky.
inline Lighting low_sun() {
    Lighting l;
    l.directional = {{normalize(glm::vec3(0.25F, 0.3F, -0.95F)), {4.0F, 3.2F, 2.4F}}};
    surround(l, [](const glm::vec3& towards) {
        return Rgb<float>(0.05F) + max(towards.y, 0.0F) * Rgb<float>(0.14F, 0.20F, 0.30F);
    });
    return l;
}

// The table, the sphere, the teapot and the knot as lesson 1 has them; the knot is of gold, with
// the constants of OpenGL's old tables.
inline std::vector<Material> tweaked() {
    std::vector<Material> m = stages::still_life().materials;
    m[3] = {.name = "gold",
            .diffuse = {0.75164F, 0.60648F, 0.22648F},
            .specular = {0.628281F, 0.555802F, 0.366065F},
            .exponent = 51.2F};
    return m;
}

// The same things by what they are: varnished or glazed, F0 = 0.04; gold has no diffuse part.
inline std::vector<Material> physical() {
    std::vector<Material> m = tweaked();
    for (Material& material : m) {
        material.specular = Rgb<float>(0.04F);
    }
    m[3].diffuse = diffuse_albedo(m[3].diffuse, true);
    m[3].specular = specular_colours[7].F0;
    return m;
}

inline void add_shelf(Mesh& mesh, float height, int first_material) {
    const auto place = [&](const Mesh& shape, const glm::vec3& at, int material) {
        const glm::mat4 there = glm::translate(glm::mat4(1.0F), at + glm::vec3(0, height, 0));
        append(mesh, transform(shape, there),
               static_cast<std::uint16_t>(first_material + material));
    };
    const auto scaled = [](float s) { return glm::scale(glm::mat4(1.0F), glm::vec3(s)); };
    const glm::mat4 standing = glm::rotate(scaled(0.62F), 1.45F, glm::vec3(1, 0.25F, 0));
    place(rounded_box({8.6F, 0.16F, 3.4F}, 0.07F, 6), {0, -0.08F, 0}, 0);
    place(sphere(0.95F, 96, 48), {-2.75F, 0.95F, 0}, 1);
    place(transform(teapot(12), scaled(0.55F)), {-0.1F, 0, 0}, 2);
    place(transform(torus_knot({}, 256, 24), standing), {2.75F, 0.92F, -0.1F}, 3);
}

// One shelf above the other; the four materials of the first, then those of the next.
inline Scene three_shelves(const std::vector<Material>& materials) {
    Scene s;
    s.materials.clear();
    for (int row = 0; row < 3; ++row) {
        add_shelf(s.mesh, -3.15F * static_cast<float>(row), static_cast<int>(s.materials.size()));
        s.materials.insert(s.materials.end(), materials.begin(), materials.end());
    }
    s.camera = {.eye = {0, 12, 60}, .target = {0, -2.35F, 0}, .fov_degrees = 8.8F, .near = 30};
    s.background = Rgb<float>(0.010F, 0.012F, 0.016F);
    return s;
}

}  // namespace glint::shelves
