#include "lessons/15_engine_integration/engine_phong.hpp"
#include "lessons/16_where_it_fails/consistent_phong.hpp"
#include "lessons/16_where_it_fails/failure_map.hpp"
#include "framework/app/lesson.hpp"
#include "framework/scene/stages.hpp"

namespace {

using namespace glint;

// Water, hard plastic and diamond at once, one to a channel.
const Rgb<float> three_f0(0.02F, 0.05F, 0.17F);

// Four maps, one above the other: total albedos of white paint under water, plastic and diamond,
// then the reciprocity error of the highlight on plastic.
template <class Brdf>
Scene maps() {
    std::vector<Rgb<double>> albedo;
    for (int row = 0; row <= failure_map::rows; ++row) {
        for (int column = 0; column <= failure_map::columns; ++column) {
            const auto n = static_cast<float>(failure_map::exponent(row));
            albedo.push_back(directional_albedo(Brdf{Rgb<float>(1.0F), three_f0, n},
                                                std::cos(failure_map::angle(column))));
        }
    }
    Scene s;
    s.materials = {{.name = "map"}, {.name = "line"}};
    for (int i = 0; i < 4; ++i) {
        const float top = 528.0F - 131.0F * static_cast<float>(i);
        const failure_map::Rectangle place{12, top - 123, 468, top};
        failure_map::add_map(s.mesh, place, [&](int column, int row) {
            const double n = failure_map::exponent(row);
            const Brdf highlight{Rgb<float>(0.0F), Rgb<float>(three_f0.g), static_cast<float>(n)};
            const auto at = static_cast<std::size_t>(row * (failure_map::columns + 1) + column);
            return i < 3 ? albedo[at][i]
                         : failure_map::worst_reciprocity_error(highlight,
                                                                failure_map::angle(column), n);
        });
        failure_map::add_lines(s.mesh, place);
    }
    const float distance = 5000;
    s.camera = {.eye = {240, 270, distance}, .target = {240, 270, 0}, .near = 4000, .far = 6000};
    s.camera.fov_degrees = glm::degrees(2 * std::atan(270 / distance));
    s.background = Rgb<float>(0.010F, 0.012F, 0.016F);
    return s;
}

// The still life, physically plausible, with a lamp more, low behind it.
Scene still_life() {
    Scene s = stages::still_life_upright();
    for (Material& m : s.materials) {
        m.specular = Rgb<float>(0.04F);
    }
    for (DirectionalLight& light : s.lighting.directional) {
        light.irradiance *= 3.0F;
    }
    s.lighting.directional.push_back(
        {normalize(glm::vec3(0.3F, 0.2F, -0.95F)), Rgb<float>(3.0F, 2.5F, 2.0F)});
    return s;
}

Scene stage(const Parameters& p) {
    return p["shaded"] > 0  ? still_life()
           : p["fixed"] > 0 ? maps<ConsistentPhong>()
                            : maps<EnginePhong>();
}

template <class Brdf>
auto shade(const Scene& s, const Material& m, const Parameters&) {
    return Lit<Brdf>{{m.diffuse, m.specular, m.exponent}, s.lighting, s.camera.eye};
}

auto plot(const Scene&, const Material& m, const Parameters&) {
    return failure_map::Plot{m.name == "line"};
}

ShaderSet shaders(const Scene& s, const Parameters& p) {
    return p["shaded"] == 0 ? shade_each_material(plot)(s, p)
           : p["fixed"] > 0 ? shade_each_material(shade<ConsistentPhong>)(s, p)
                            : shade_each_material(shade<EnginePhong>)(s, p);
}

}  // namespace

int main(int argc, char** argv) {
    return run_lesson(
        argc, argv,
        {.name = "16_where_it_fails",
         .title = "Lesson 16: where the model fails, and a fix that keeps both rules",
         .parameters = {{"fixed", 1, 0, 1, "0: lesson 15, 1: the consistent fix", true},
                        {"shaded", 0, 0, 1, "0: maps of failures, 1: a still life", true}},
         .panels = {{{"fixed", 0}}, {{"fixed", 1}}},
         .stage = stage,
         .shaders = shaders});
}
