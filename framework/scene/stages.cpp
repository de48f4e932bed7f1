#include "framework/scene/stages.hpp"

#include "framework/geometry/shapes.hpp"
#include "framework/math/error.hpp"

#include <glm/gtc/matrix_transform.hpp>
#include <glm/trigonometric.hpp>

#include <algorithm>
#include <cmath>

namespace glint::stages {
namespace {

glm::mat4 at(const glm::vec3& position, float scale = 1.0F) {
    return glm::scale(glm::translate(glm::mat4(1.0F), position), glm::vec3(scale));
}

// A shape that lies round the y axis, set on its edge and turned towards the eye.
glm::mat4 standing(const glm::vec3& position, float scale) {
    return glm::rotate(at(position, scale), 1.45F, glm::vec3(1, 0.25F, 0));
}

struct Places {
    glm::vec3 sphere, teapot, knot;
    float teapot_scale;
};

// A sphere, the teapot and a torus knot on a round table.
Scene laid_table(const Places& places) {
    Scene s;
    s.materials = {
        {.name = "table", .diffuse = {0.32F, 0.30F, 0.28F}, .exponent = 30.0F},
        {.name = "clay", .diffuse = {0.62F, 0.20F, 0.11F}, .specular = Rgb<float>(0.35F)},
        {.name = "porcelain",
         .diffuse = {0.60F, 0.58F, 0.52F},
         .specular = Rgb<float>(0.5F),
         .exponent = 120.0F},
        {.name = "paint",
         .diffuse = {0.07F, 0.20F, 0.48F},
         .specular = Rgb<float>(0.45F),
         .exponent = 25.0F},
    };
    const glm::vec2 table[] = {{0, -0.3F}, {5.0F, -0.3F}, {5.2F, -0.1F}, {5.1F, 0}, {0, 0}};
    s.mesh = surface_of_revolution(table, 128);
    s.mesh.materials.assign(s.mesh.triangles.size(), 0);
    append(s.mesh, transform(sphere(1.0F, 96, 48), at(places.sphere)), 1);
    append(s.mesh, transform(teapot(12), at(places.teapot, places.teapot_scale)), 2);
    append(s.mesh, transform(torus_knot({}, 256, 24), standing(places.knot, 0.68F)), 3);
    s.lighting = key_and_fill();
    s.background = Rgb<float>(0.010F, 0.012F, 0.016F);
    return s;
}

}  // namespace

Lighting key_and_fill() {
    return {.directional = {{normalize(glm::vec3(-0.55F, 0.75F, 0.6F)), {1.0F, 0.97F, 0.92F}},
                            {normalize(glm::vec3(0.85F, 0.35F, 0.25F)), {0.16F, 0.20F, 0.28F}}},
            .point = {},
            .ambient = {0.05F, 0.055F, 0.065F}};
}

Lighting three_lamps() {
    return {.directional = {{normalize(glm::vec3(-0.55F, 0.75F, 0.6F)), {1.0F, 0.97F, 0.92F}},
                            {normalize(glm::vec3(0.75F, 0.55F, 0.6F)), Rgb<float>(1.0F)},
                            {normalize(glm::vec3(0.1F, 0.35F, 1.0F)), Rgb<float>(1.0F)}},
            .point = {},
            .ambient = {0.05F, 0.055F, 0.065F}};
}

Scene still_life() {
    Scene s = laid_table({{-2.7F, 1.0F, 0.1F}, {-0.1F, 0.0F, 0.0F}, {2.75F, 1.0F, -0.1F}, 0.58F});
    s.camera = {.eye = {0.3F, 2.5F, 8.6F},
                .target = {0.0F, 0.78F, 0.0F},
                .fov_degrees = 29.5F,
                .near = 1.0F,
                .far = 40.0F};
    return s;
}

Scene still_life_upright() {
    Scene s = laid_table({{-1.1F, 1.0F, -0.9F}, {-0.05F, 0.0F, 1.4F}, {1.2F, 1.0F, -0.9F}, 0.45F});
    s.camera = {.eye = {0.3F, 2.7F, 9.6F},
                .target = {0.07F, 0.8F, 0.0F},
                .fov_degrees = 27.0F,
                .near = 1.0F,
                .far = 40.0F};
    return s;
}

Scene sphere_grid(const std::vector<Material>& materials, int columns, float aspect) {
    if (materials.empty() || columns < 1) {
        throw Error("sphere_grid: needs a material and a column");
    }
    const float pitch = 2.3F;
    const auto count = static_cast<int>(materials.size());
    const int rows = (count + columns - 1) / columns;
    Scene s;
    s.materials = materials;
    for (int i = 0; i < count; ++i) {
        const auto column =
            static_cast<float>(i % columns) - 0.5F * static_cast<float>(columns - 1);
        const int line = i / columns;
        const auto row = static_cast<float>(line) - 0.5F * static_cast<float>(rows - 1);
        append(s.mesh, transform(sphere(1.0F, 96, 48), at({pitch * column, -pitch * row, 0})),
               static_cast<std::uint16_t>(i));
    }
    s.lighting.directional = {{normalize(glm::vec3(-0.5F, 0.6F, 0.8F)), Rgb<float>(1.0F)}};
    s.camera = {.eye = {0, 0, 1}, .fov_degrees = 20.0F};
    const float height = 0.55F * pitch * static_cast<float>(rows);
    const float width = 0.55F * pitch * static_cast<float>(columns);
    const float half = std::max(height, width / aspect);
    s.camera.eye.z = 1.0F + half / std::tan(glm::radians(10.0F));
    s.camera.near = 0.5F * s.camera.eye.z;
    s.camera.far = 2.0F * s.camera.eye.z;
    s.background = Rgb<float>(0.010F, 0.012F, 0.016F);
    return s;
}

}  // namespace glint::stages
