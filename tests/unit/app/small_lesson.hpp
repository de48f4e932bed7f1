// A small lesson for the tests of the program: a ball before a wall, of two materials.
#pragma once

#include "lessons/01_ad_hoc_phong/ad_hoc_phong.hpp"
#include "framework/app/lesson.hpp"
#include "framework/geometry/shapes.hpp"

#include <glm/gtc/matrix_transform.hpp>

namespace glint {

inline Scene ball_before_wall() {
    Scene s;
    s.materials = {{.name = "wall", .diffuse = {0.2F, 0.4F, 0.6F}},
                   {.name = "ball", .diffuse = {0.8F, 0.3F, 0.1F}, .exponent = 40}};
    const glm::mat4 upright = glm::rotate(glm::mat4(1.0F), 1.5707963F, glm::vec3(1, 0, 0));
    s.mesh = transform(plane(2, 2, 2, 2), glm::translate(glm::mat4(1.0F), {0, 0, -2}) * upright);
    s.mesh.materials.assign(s.mesh.triangles.size(), 0);
    append(s.mesh, sphere(0.8F, 24, 12), 1);
    s.lighting.directional = {{{0, 0.6F, 0.8F}, Rgb<float>(1.5F)}};
    s.lighting.point = {{{2, 2, 2}, Rgb<float>(3.0F)}};
    s.lighting.ambient = Rgb<float>(0.05F);
    s.camera = {.eye = {0, 0, 4}, .fov_degrees = 45, .near = 0.5F, .far = 20};
    s.background = Rgb<float>(0.125F);
    return s;
}

inline Lesson small_lesson() {
    return {
        .name = "00_small",
        .title = "A ball before a wall",
        .parameters = {},
        .stage = [](const Parameters&) { return ball_before_wall(); },
        .shaders = shade_each_material([](const Scene& s, const Material& m, const Parameters&) {
            return AdHocPhong{m, s.lighting, s.camera.eye};
        })};
}

inline Options small_options() {
    Options o;
    o.width = 90;
    o.height = 70;
    o.outs = {"a.png", "a.pfm"};
    return o;
}

}  // namespace glint
