#include "lessons/01_ad_hoc_phong/ad_hoc_phong.hpp"
#include "lessons/15_engine_integration/engine_phong.hpp"
#include "lessons/15_engine_integration/lit_from_afar.hpp"
#include "lessons/15_engine_integration/shelves.hpp"
#include "framework/app/lesson.hpp"

namespace {

using namespace glint;

Scene stage(const Parameters& p) {
    return shelves::three_shelves(p["model"] == 1 ? shelves::tweaked() : shelves::physical());
}

// Each shelf has its own; lights from the command line are for all.
Lighting lights_for(const Scene& s, const Material& m) {
    if (!s.lighting.directional.empty() || !s.lighting.point.empty()) {
        return s.lighting;
    }
    const auto shelf = static_cast<std::size_t>(&m - s.materials.data()) / 4;
    Lighting lights = shelf == 0   ? shelves::lamp()
                      : shelf == 1 ? shelves::window()
                                   : shelves::low_sun();
    lights.ambient = s.lighting.ambient;
    return lights;
}

// In radiance; --tolerance chooses.
float least_highlight(const Parameters& p) {
    constexpr float codes[] = {0, 1e-3F, 0.25F};
    return radiance_of_codes(codes[static_cast<int>(p["highlights"])]);
}

EnginePhong brdf_of(const Material& m) {
    return {m.diffuse, m.specular, m.exponent};
}

auto lesson_1(const Scene& s, const Material& m, const Parameters&) {
    return AdHocPhong{m, lights_without_pi(lights_for(s, m)), s.camera.eye};
}

WhereItShows where_it_shows(const Material& m, const Lighting& lights, const Parameters& p) {
    const EnginePhong phong = brdf_of(m);
    return {phong, highlight_from(phong, lights, least_highlight(p))};
}

auto with_pi(const Scene& s, const Material& m, const Parameters& p) {
    const Lighting lights = lights_for(s, m);
    return Lit<WhereItShows>{where_it_shows(m, lights, p), lights, s.camera.eye};
}

auto from_afar(const Scene& s, const Material& m, const Parameters& p) {
    const Lighting lights = lights_for(s, m);
    return LitFromAfar{where_it_shows(m, lights, p), lights};
}

auto without_pi(const Scene& s, const Material& m, const Parameters&) {
    return Lit<EnginePhongWithoutPi>{
        {brdf_of(m)}, lights_without_pi(lights_for(s, m)), s.camera.eye};
}

ShaderSet shaders(const Scene& s, const Parameters& p) {
    return p["model"] == 1            ? shade_each_material(lesson_1)(s, p)
           : p["pi"] == 0             ? shade_each_material(without_pi)(s, p)
           : s.lighting.point.empty() ? shade_each_material(from_afar)(s, p)
                                      : shade_each_material(with_pi)(s, p);
}

}  // namespace

int main(int argc, char** argv) {
    return run_lesson(
        argc, argv,
        {.name = "15_engine_integration",
         .title = "Lesson 15: normalised Phong with Fresnel, beside lesson 1",
         .parameters = {{"model", 15, 1, 15, "1: lesson 1, else this lesson", true},
                        {"pi", 1, 0, 1, "0: BRDF times pi, lights over pi", true},
                        {"highlights",
                         0,
                         0,
                         2,
                         "0: computed everywhere, 1, 2: where they show",
                         true,
                         {"highlights everywhere", "highlights of 1/1000 code and more",
                          "highlights of 1/4 code and more"}}},
         .panels = {{{"model", 1}}, {{"model", 15}}},
         .stage = stage,
         .shaders = shaders});
}
