// What lesson 17 draws, and the forms that a plan chooses from.
#pragma once

#include "lessons/15_engine_integration/shelves.hpp"
#include "lessons/17_speed_and_accuracy/thrifty_brdf.hpp"
#include "framework/app/lesson.hpp"
#include "framework/geometry/shapes.hpp"

#include <glm/gtc/matrix_transform.hpp>

namespace glint::thrift {

// A silver ball, a porcelain teapot and a copper knot, one above the other, in a white room with a
// lamp.
inline Scene still_life(const Parameters&) {
    const glm::mat4 stay(1.0F);
    const auto place = [&](float height, float size) {
        return glm::scale(glm::translate(stay, {0, height, 0}), glm::vec3(size));
    };
    const auto turned = glm::rotate(place(-2.05F, 0.6F), 1.45F, glm::vec3(1, 0.25F, 0));
    Scene s;
    s.materials = {{.name = "silver", .diffuse = Rgb<float>(0.0F), .exponent = 40.5F},
                   {.name = "porcelain",
                    .diffuse = {0.60F, 0.58F, 0.52F},
                    .specular = Rgb<float>(0.05F),
                    .exponent = 120.5F},
                   {.name = "copper", .diffuse = Rgb<float>(0.0F), .exponent = 40.5F}};
    append(s.mesh, transform(sphere(1.0F, 96, 48), place(2.05F, 0.98F)), 0);
    append(s.mesh, transform(teapot(12), place(-0.55F, 0.52F)), 1);
    append(s.mesh, transform(torus_knot({}, 256, 24), turned), 2);
    s.lighting = shelves::lamp();
    s.camera = {.eye = {0, 4, 30}, .fov_degrees = 12.4F, .near = 10, .far = 60};
    s.background = Rgb<float>(0.010F, 0.012F, 0.016F);
    return s;
}

// Of lesson 15, in radiance.
inline float least_highlight(const Parameters& p) {
    constexpr float codes[] = {0, 1e-3F, 0.25F, 1};
    return radiance_of_codes(codes[static_cast<int>(p["highlights"])]);
}

inline auto thrifty(const Scene& s, const Material& m, const Parameters& p) {
    const Surface surface = surface_of(m);
    const bool metal = surface.k != Rgb<float>(0.0F);
    return Lit<ThriftyPhong>{
        {surface, static_cast<Fresnel>(static_cast<int>(p[metal ? "metals" : "dielectrics"])),
         p["power"] > 0, highlight_from(surface, s.lighting, least_highlight(p))},
        s.lighting,
        s.camera.eye};
}

inline Parameter fresnel_of(const std::string& materials) {
    return {materials,
            0,
            0,
            3,
            "Fresnel of " + materials + ", 0: exact, 1: Lazanyi, 2: Schlick, 3: F0",
            true,
            {"exact Fresnel of " + materials, "Lazanyi's for " + materials,
             "Schlick's for " + materials, "F0 at every angle for " + materials}};
}

inline const Parameters forms{
    fresnel_of("metals"),
    fresnel_of("dielectrics"),
    {"power", 0, 0, 1, "0: pow(), 1: by four terms", true, {"pow()", "pow by four terms"}},
    {"highlights",
     0,
     0,
     3,
     "0: computed everywhere, 1 to 3: where they show",
     true,
     {"highlights everywhere", "highlights of 1/1000 code and more",
      "highlights of 1/4 code and more", "highlights of 1 code and more"}}};

}  // namespace glint::thrift
