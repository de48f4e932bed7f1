// Samples a pixel, shaded by pixel and triangle or each for itself, against 256.
#include "lessons/15_engine_integration/engine_phong.hpp"
#include "framework/scene/stages.hpp"
#include "framework/geometry/shapes.hpp"
#include "docs/charts/families.hpp"
#include "docs/charts/picture.hpp"

namespace glint::charts {
namespace {

auto final_model(const Scene& s, const Material& m) {
    return Lit<EnginePhong>{{m.diffuse, m.specular, m.exponent}, s.lighting, s.camera.eye};
}

Scene still_life() {
    Scene s = stages::still_life();
    for (Material& m : s.materials) {
        m.specular = Rgb<float>(0.04F);
    }
    for (DirectionalLight& light : s.lighting.directional) {
        light.irradiance *= 3.0F;
    }
    return s;
}

// A knot whose windings are thin and whose highlights are sharp.
Scene thin_knot() {
    Scene s;
    s.mesh = torus_knot({.p = 5, .q = 13, .tube = 0.02F}, 2048, 8);
    s.materials = {{.diffuse = Rgb<float>(0.2F), .exponent = 2000}};
    s.lighting.directional = {{normalize(glm::vec3(-0.5F, 0.6F, 0.8F)), Rgb<float>(3.0F)}};
    s.camera = frame(s.mesh, {.eye = {0, 2, 3}, .fov_degrees = 25}, 16.0F / 9);
    s.background = Rgb<float>(0.010F, 0.012F, 0.016F);
    return s;
}

void add_all(std::vector<Contender>& all, const Scene& scene, const char* name) {
    const auto stage = std::make_shared<const Stage>(stage_of(scene, 480, 270, final_model));
    const Codes reference = draw_256_samples(*stage);
    const auto add = [&](int samples, bool each) {
        const Settings settings{.samples = samples, .sample_shading = each};
        const std::string method = std::to_string(samples) +
                                   (samples == 1 ? " sample" : " samples") +
                                   (each ? " each shaded" : "");
        all.push_back(frame_contender(
            method, stage, settings,
            {{name, "codes", difference(draw_codes(*stage, settings), reference)}}));
    };
    add(1, false);
    for (const int samples : {2, 4, 8, 16}) {
        add(samples, false);
        add(samples, true);
    }
}

}  // namespace

std::vector<Contender> antialiasing_contenders() {
    std::vector<Contender> all;
    add_all(all, still_life(), "still life");
    add_all(all, thin_knot(), "thin knot");
    return all;
}

}  // namespace glint::charts
