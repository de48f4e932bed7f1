#include "lessons/00_hello_shader/hello_shader.hpp"
#include "framework/app/lesson.hpp"
#include "framework/scene/stages.hpp"
#include "framework/geometry/shapes.hpp"

#include <glm/gtc/matrix_transform.hpp>

namespace {

using namespace glint;

// Three corners with normals of their own.
Mesh one_triangle() {
    Mesh mesh;
    mesh.positions = {{-1.05F, -0.85F, 0}, {1.05F, -0.85F, 0}, {0, 1.0F, 0}};
    for (const glm::vec3& p : mesh.positions) {
        mesh.normals.push_back(normalize(p + glm::vec3(0, 0, 0.7F)));
    }
    mesh.triangles = {{0, 1, 2}};
    return mesh;
}

// Moved there, scaled, then leaning towards the eye and turned to the right, radians.
glm::mat4 at(const glm::vec3& position, float scale, float lean, float turn) {
    const glm::mat4 there = glm::scale(glm::translate(glm::mat4(1), position), glm::vec3(scale));
    const glm::mat4 leant = glm::rotate(there, lean, glm::vec3(1, 0, 0));
    return glm::rotate(leant, turn, glm::vec3(0, 1, 0));
}

// One triangle, twenty, and the teapot's thousands.
Scene from_one_to_many(const Parameters&) {
    Scene s;
    s.materials = {{.name = "normals"}};
    append(s.mesh, transform(one_triangle(), at({-3.2F, -0.1F, 0}, 1.2F, 0, 0)));
    append(s.mesh, transform(icosphere(1.3F, 0), at({-0.55F, 0, 0}, 1, 0.25F, 0.3F)));
    append(s.mesh, transform(teapot(8), at({2.5F, -0.75F, 0}, 0.5F, 0.35F, -0.3F)));
    s.camera = {.eye = {0, 0, 12}, .fov_degrees = 25.5F, .near = 5.0F, .far = 20.0F};
    s.background = Rgb<float>(0.010F, 0.012F, 0.016F);
    return s;
}

}  // namespace

int main(int argc, char** argv) {
    return run_lesson(
        argc, argv,
        {.name = "00_hello_shader",
         .title = "Lesson 0: a surface's normal as its colour",
         .parameters = {{"brightness", 1, 0, 2, "a factor on the colour"}},
         .stage = from_one_to_many,
         .shaders = shade_each_material([](const Scene&, const Material&, const Parameters& p) {
             return HelloShader{p["brightness"]};
         })});
}
