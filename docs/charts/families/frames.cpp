// Whole frames of lessons 1, 9, 15 and 16, by all that a lesson's program can be told about how to
// draw: against 256 samples a pixel, and, of what takes one sample, against double at pixel
// centres.
#include "lessons/01_ad_hoc_phong/ad_hoc_phong.hpp"
#include "lessons/15_engine_integration/engine_phong.hpp"
#include "lessons/15_engine_integration/shelves.hpp"
#include "lessons/15_engine_integration/where_it_shows.hpp"
#include "lessons/16_where_it_fails/consistent_phong.hpp"
#include "framework/scene/stages.hpp"
#include "framework/math/dispatch.hpp"
#include "docs/charts/families.hpp"
#include "docs/charts/picture.hpp"

namespace glint::charts {
namespace {

template <class Brdf>
auto lit(const Scene& s, const Material& m) {
    return Lit<Brdf>{{m.diffuse, m.specular, m.exponent}, s.lighting, s.camera.eye};
}

// The lessons' pictures are two panels side by side; these are one panel, and full.
constexpr int width = 640;
constexpr int height = 360;

Stage ad_hoc_phong() {
    return stage_of(stages::still_life(), width, height, [](const Scene& s, const Material& m) {
        return AdHocPhong{m, s.lighting, s.camera.eye};
    });
}

Stage normalised_phong() {
    std::vector<Material> materials;
    for (const float n : {2.0F, 8.0F, 32.0F, 128.0F, 512.0F, 2048.0F}) {
        materials.push_back({.diffuse = Rgb<float>(0.18F, 0.03F, 0.02F),
                             .specular = Rgb<float>(0.05F),
                             .exponent = n});
    }
    Scene s = stages::sphere_grid(materials, 3, 16.0F / 9);
    s.lighting.directional[0].irradiance = Rgb<float>(3.0F);
    s.lighting.ambient = Rgb<float>(0.1F);
    return stage_of(std::move(s), width, height, lit<NormalisedPhong>);
}

// Three shelves, each in a light of its own; highlights from so many codes on.
Stage engine_phong(float codes) {
    const auto make = [codes,
                       lights = std::array{shelves::lamp(), shelves::window(), shelves::low_sun()}](
                          const Scene& s, const Material& m) {
        const Lighting& light = lights.at(static_cast<std::size_t>(&m - s.materials.data()) / 4);
        const EnginePhong phong{m.diffuse, m.specular, m.exponent};
        const float from = highlight_from(phong, light, radiance_of_codes(codes));
        return Lit<WhereItShows>{{phong, from}, light, s.camera.eye};
    };
    return stage_of(shelves::three_shelves(shelves::physical()), width, height, make);
}

Stage consistent_phong() {
    Scene s = stages::still_life();
    for (Material& m : s.materials) {
        m.specular = Rgb<float>(0.04F);
    }
    for (DirectionalLight& light : s.lighting.directional) {
        light.irradiance *= 3.0F;
    }
    return stage_of(std::move(s), width, height, lit<ConsistentPhong>);
}

// How to draw, by the name that the charts give it.
struct Way {
    std::string name;
    Settings settings;
};

std::vector<Way> ways() {
    std::vector<Way> all{{"scanline", {.rasterizer = Rasterizer::scanline}}};
    for (const int lanes : {1, 4, 8, 16}) {
        if (has_lanes(lanes)) {
            all.push_back({"lanes " + std::to_string(lanes), {.lanes = lanes}});
        }
    }
    for (const int samples : {2, 4, 8, 16}) {
        const std::string name = "samples " + std::to_string(samples);
        all.push_back({name, {.samples = samples}});
        all.push_back({name + " shaded", {.samples = samples, .sample_shading = true}});
    }
    return all;
}

// A lesson's shaders in full, and cheaper: what --tolerance may choose goes here.
struct Form {
    std::string name;
    Stage stage;
};

class Lesson {
  public:
    Lesson(std::vector<Contender>& all, std::string name, const Stage& full)
        : all_(all),
          name_(std::move(name)),
          smooth_(draw_256_samples(full)),
          exact_(draw_codes(full, {.rasterizer = Rasterizer::reference})) {}

    void add(const Way& way, const std::shared_ptr<const Stage>& stage) {
        const Codes codes = draw_codes(*stage, way.settings);
        std::vector<Judgement> judgements{{name_, "codes", difference(codes, smooth_)}};
        if (way.settings.samples == 1) {
            judgements.push_back({name_ + " at pixel centres", "codes", difference(codes, exact_)});
        }
        all_.push_back(frame_contender(way.name, stage, way.settings, std::move(judgements)));
    }

  private:
    std::vector<Contender>& all_;
    std::string name_;
    Codes smooth_, exact_;
};

void add_all(std::vector<Contender>& all, const std::string& name, const Stage& full,
             const std::vector<Form>& cheaper = {}) {
    Lesson lesson(all, name, full);
    const auto stage = std::make_shared<const Stage>(full);
    for (const Way& way : ways()) {
        lesson.add(way, stage);
    }
    for (const Form& form : cheaper) {
        const auto cheap = std::make_shared<const Stage>(form.stage);
        lesson.add({form.name, {}}, cheap);
        lesson.add({form.name + " samples 4", {.samples = 4}}, cheap);
    }
}

}  // namespace

std::vector<Contender> frames_contenders() {
    std::vector<Contender> all;
    add_all(all, "lesson 1", ad_hoc_phong());
    add_all(all, "lesson 9", normalised_phong());
    add_all(all, "lesson 15", engine_phong(0),
            {{"highlights 1/1000", engine_phong(1e-3F)}, {"highlights 1/4", engine_phong(0.25F)}});
    add_all(all, "lesson 16", consistent_phong());
    return all;
}

}  // namespace glint::charts
