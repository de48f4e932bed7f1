#include "lessons/10_fresnel_dielectric/fresnel_dielectric.hpp"
#include "lessons/10_fresnel_dielectric/polished.hpp"
#include "framework/app/lesson.hpp"
#include "framework/geometry/shapes.hpp"

#include <glm/gtc/matrix_transform.hpp>

namespace {

using namespace glint;

// A glazed teapot on a lacquered table, and the studio around them as a wall of light.
Scene tea(const Parameters&) {
    Scene s;
    s.materials = {{.name = "studio"},
                   {.name = "table", .diffuse = {0.010F, 0.009F, 0.008F}},
                   {.name = "teapot", .diffuse = {0.02F, 0.10F, 0.16F}}};
    s.mesh = sphere(60.0F, 64, 32);
    s.mesh.materials.assign(s.mesh.triangles.size(), 0);
    const glm::vec2 table[] = {{0, -0.2F}, {6, -0.2F}, {6, 0}, {0, 0}};
    append(s.mesh, surface_of_revolution(table, 256), 1);
    const glm::mat4 left = glm::translate(glm::mat4(1.0F), glm::vec3(-0.1F, 0, 0));
    append(s.mesh, transform(teapot(16), glm::scale(left, glm::vec3(0.58F))), 2);
    s.lighting.directional = {{normalize(glm::vec3(-0.565F, 0.566F, 0.6F)), Rgb<float>(2.0F)}};
    s.lighting.ambient = Rgb<float>(0.2F);
    s.camera = {.eye = {0, 1.6F, 9.0F}, .target = {0, 0.6F, 0}, .fov_degrees = 30, .near = 1};
    return s;
}

struct Dielectric {
    float n1, n2;
    bool by_angle;

    template <Real T>
    Rgb<T> operator()(const T& cos_i) const {
        const T cosine = by_angle ? cos_i : T(1.0F);
        return Rgb<T>(fresnel_dielectric(T(n1), T(n2), cosine).unpolarised);
    }
};

}  // namespace

int main(int argc, char** argv) {
    return run_lesson(
        argc, argv,
        {.name = "10_fresnel_dielectric",
         .title = "Lesson 10: Fresnel's reflectance of dielectrics, beside a constant one",
         .parameters = {{"fresnel", 1, 0, 1, "0: R as along the normal, 1: R by the angle", true},
                        {"n1", 1, 0.1F, 10, "refractive index on the viewer's side"},
                        {"n2", 1.5F, 0.1F, 10, "refractive index beneath the surface"}},
         .panels = {{{"fresnel", 0}}, {{"fresnel", 1}}},
         .stage = tea,
         .shaders = shade_each_material([](const Scene& s, const Material& m, const Parameters& p) {
             return Polished<Dielectric>{{{m.diffuse}, s.lighting, s.camera.eye},
                                         {p["n1"], p["n2"], p["fresnel"] > 0},
                                         {},
                                         m.name == "studio"};
         })});
}
