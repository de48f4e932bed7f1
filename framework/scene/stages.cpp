#include "framework/scene/stages.hpp"

#include "framework/geometry/shapes.hpp"

#include <glm/gtc/matrix_transform.hpp>

namespace glint::stages {
namespace {

glm::mat4 at(const glm::vec3& position, float scale = 1.0F) {
    return glm::scale(glm::translate(glm::mat4(1.0F), position), glm::vec3(scale));
}

}  // namespace

Scene still_life() {
    Scene s;
    s.materials = {
        {.name = "ground", .diffuse = {0.35F, 0.36F, 0.38F}, .exponent = 30.0F},
        {.name = "clay", .diffuse = {0.75F, 0.22F, 0.13F}, .exponent = 60.0F},
        {.name = "porcelain", .diffuse = {0.80F, 0.78F, 0.70F}, .exponent = 200.0F},
        {.name = "paint", .diffuse = {0.08F, 0.25F, 0.60F}, .exponent = 20.0F},
    };
    s.mesh = plane(40.0F, 40.0F, 1, 1);
    s.mesh.materials.assign(s.mesh.triangles.size(), 0);
    append(s.mesh, transform(sphere(1.0F, 96, 48), at({-2.6F, 1.0F, 0.2F})), 1);
    append(s.mesh, transform(teapot(12), at({0.0F, 0.0F, 0.0F}, 0.62F)), 2);
    append(s.mesh, transform(torus_knot({}, 256, 24), at({2.8F, 1.15F, 0.0F}, 0.55F)), 3);
    s.lighting.directional = {
        {normalize(glm::vec3(-0.5F, 0.9F, 0.6F)), Rgb<float>(1.9F, 1.85F, 1.75F)},
        {normalize(glm::vec3(0.8F, 0.35F, 0.4F)), Rgb<float>(0.35F, 0.42F, 0.55F)},
    };
    s.lighting.ambient = Rgb<float>(0.06F, 0.07F, 0.09F);
    s.camera = {.eye = {0.3F, 2.3F, 7.6F},
                .target = {0.1F, 0.85F, 0.0F},
                .fov_degrees = 32.0F,
                .near = 1.0F,
                .far = 60.0F};
    s.background = Rgb<float>(0.012F, 0.014F, 0.018F);
    return s;
}

}  // namespace glint::stages
