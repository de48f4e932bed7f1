#include "lessons/04_rendering_equation/rendering_equation.hpp"
#include "lessons/08_normalised_lambert/normalised_lambert.hpp"
#include "framework/app/lesson.hpp"
#include "framework/scene/stages.hpp"

namespace {

using namespace glint;

// Matt things under one lamp, E = 3; what is white reflects all that it gets.
Scene matt_still_life(const Parameters&) {
    Scene s = stages::still_life_upright();
    s.materials[2].diffuse = Rgb<float>(1.0F);
    s.lighting.directional.resize(1);
    s.lighting.directional[0].irradiance = Rgb<float>(3.0F);
    s.lighting.ambient = Rgb<float>(0.05F);
    return s;
}

struct Either {
    NormalisedLambert lambert;
    bool normalised;

    template <Real T>
    Rgb<T> operator()(const Incidence<T>& g) const {
        return normalised ? lambert(g) : Rgb<T>(lambert_unnormalised(lambert.Cd));
    }
    Rgb<float> ambient_albedo() const {
        return lambert.ambient_albedo() * (normalised ? 1.0F : std::numbers::pi_v<float>);
    }
};

}  // namespace

int main(int argc, char** argv) {
    return run_lesson(
        argc, argv,
        {.name = "08_normalised_lambert",
         .title = "Lesson 8: Lambert's BRDF with 1/pi, beside the one without",
         .parameters = {{"normalised", 1, 0, 1, "0: Cd, 1: Cd/pi", true}},
         .panels = {{{"normalised", 0}}, {{"normalised", 1}}},
         .stage = matt_still_life,
         .shaders = shade_each_material([](const Scene& s, const Material& m, const Parameters& p) {
             return Lit<Either>{{{m.diffuse}, p["normalised"] > 0}, s.lighting, s.camera.eye};
         })});
}
