#include "lessons/06_energy/energy.hpp"
#include "lessons/06_energy/furnace.hpp"
#include "lessons/06_energy/plot.hpp"
#include "framework/app/lesson.hpp"
#include "framework/scene/stages.hpp"

#include <glm/trigonometric.hpp>

namespace {

using namespace glint;

// Lambert's constant thrice, then Phong's lobe of six exponents.
std::vector<Material> surfaces() {
    std::vector<Material> all;
    for (const float Cd : {0.1F, std::numbers::inv_pi_v<float>, 1.0F}) {
        all.push_back({.diffuse = Rgb<float>(Cd), .specular = Rgb<float>(0.0F)});
    }
    for (const float n : {1.0F, 2.0F, 4.0F, 10.0F, 100.0F, 1000.0F}) {
        all.push_back({.diffuse = Rgb<float>(0.0F), .specular = Rgb<float>(1.0F), .exponent = n});
    }
    return all;
}

LambertPhong brdf_of(const Material& m) {
    return {m.diffuse, m.specular, m.exponent};
}

// They hang in the furnace, whose walls have radiance 1.
Scene spheres() {
    Scene s = stages::sphere_grid(surfaces(), 3, 8.0F / 9.0F);
    s.camera.eye.z *= 0.9F;
    s.background = false_colour(1.0F);
    return s;
}

// Their albedos by the angle of the light, by this lesson's own sum.
Scene curves() {
    Scene s;
    s.materials = {{.name = "curve"}, {.name = "grey"}};
    plot::add_axes(s.mesh);
    for (const Material& m : surfaces()) {
        std::vector<glm::vec2> points;
        std::vector<float> values;
        for (int i = 0; i <= 60; ++i) {
            const double degrees = 1.5 * i;
            const double share = albedo(brdf_of(m), glm::radians(degrees), 48);
            points.push_back(plot::place(degrees, share));
            values.push_back(static_cast<float>(share));
        }
        plot::add_line(s.mesh, points, values, 4, 0);
    }
    const float distance = 5000;
    s.camera = {.eye = {240, 270, distance}, .target = {240, 270, 0}, .near = 4000, .far = 6000};
    s.camera.fov_degrees = glm::degrees(2 * std::atan(270 / distance));
    s.background = Rgb<float>(0.06F);
    return s;
}

auto in_furnace(const Scene& s, const Material& m, const Parameters&) {
    return Furnace{AlbedoCurve(brdf_of(m), Fixed::view), s.camera.eye};
}

auto in_plot(const Scene&, const Material& m, const Parameters&) {
    return plot::Plot{m.name == "grey"};
}

}  // namespace

int main(int argc, char** argv) {
    return run_lesson(
        argc, argv,
        {.name = "06_energy",
         .title = "Lesson 6: no more light leaves than arrives",
         .parameters = {{"curves", 0, 0, 1, "0: spheres in a furnace, 1: albedo by angle", true}},
         .panels = {{{"curves", 0}}, {{"curves", 1}}},
         .stage = [](const Parameters& p) { return p["curves"] > 0 ? curves() : spheres(); },
         .shaders =
             [](const Scene& s, const Parameters& p) {
                 return p["curves"] > 0 ? shade_each_material(in_plot)(s, p)
                                        : shade_each_material(in_furnace)(s, p);
             }});
}
