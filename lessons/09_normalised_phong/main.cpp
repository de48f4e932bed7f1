#include "lessons/04_rendering_equation/rendering_equation.hpp"
#include "lessons/09_normalised_phong/normalised_phong.hpp"
#include "framework/app/lesson.hpp"
#include "framework/scene/stages.hpp"

namespace {

using namespace glint;

// Six exponents, two to a row; the key light is the same for all.
Scene exponents(const Parameters&) {
    std::vector<Material> materials;
    for (const float n : {2.0F, 8.0F, 32.0F, 128.0F, 512.0F, 2048.0F}) {
        materials.push_back({.diffuse = Rgb<float>(0.18F, 0.03F, 0.02F), .exponent = n});
    }
    Scene s = stages::sphere_grid(materials, 2, 8.0F / 9.0F);
    s.lighting.directional[0].irradiance = Rgb<float>(3.0F);
    s.lighting.ambient = Rgb<float>(0.1F);
    return s;
}

// The lobe's colour is 5 %: as bright as glass.
Rgb<float> lobe_colour() {
    return Rgb<float>(0.05F);
}

struct Either {
    NormalisedPhong phong;
    bool normalised;

    template <Real T>
    Rgb<T> operator()(const Incidence<T>& g) const {
        return normalised ? phong(g)
                          : NormalisedLambert{phong.Cd}(g) + phong.Ks * phong_lobe(g, T(phong.n));
    }
    Rgb<float> ambient_albedo() const { return phong.ambient_albedo(); }
};

}  // namespace

int main(int argc, char** argv) {
    return run_lesson(
        argc, argv,
        {.name = "09_normalised_phong",
         .title = "Lesson 9: Phong's lobe with (n + 2)/(2 pi), beside the one without",
         .parameters = {{"normalised", 1, 0, 1, "0: (V.R)^n, 1: (n + 2)/(2 pi) (V.R)^n", true}},
         .panels = {{{"normalised", 0}}, {{"normalised", 1}}},
         .stage = exponents,
         .shaders = shade_each_material([](const Scene& s, const Material& m, const Parameters& p) {
             return Lit<Either>{{{m.diffuse, lobe_colour(), m.exponent}, p["normalised"] > 0},
                                s.lighting,
                                s.camera.eye};
         })});
}
