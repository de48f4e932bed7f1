#include "framework/app/panels.hpp"

#include <algorithm>

namespace glint {
namespace {

constexpr Rgba8 line{24, 24, 24, 255};

// By the command line, or in the window, or to be chosen by a plan.
bool is_set(const Lesson& lesson, const Options& o, const std::string& parameter) {
    const auto chosen = [&](const Parameter& p) {
        return p.name == parameter && !p.forms.empty() && o.tolerance > 0;
    };
    const auto& all = lesson.parameters.all();
    return std::any_of(all.begin(), all.end(), chosen) ||
           std::find(o.set.begin(), o.set.end(), parameter) != o.set.end() ||
           o.parameters[parameter] != lesson.parameters[parameter];
}

template <class Pixel>
void paste(const Image<Pixel>& part, int left, Image<Pixel>& whole) {
    for (int y = 0; y < part.height(); ++y) {
        std::copy(part.row(y).begin(), part.row(y).end(), whole.row(y).begin() + left);
    }
}

void add(const Statistics& part, Statistics& sum) {
    for (const auto member :
         {&Statistics::geometry_ms, &Statistics::visibility_ms, &Statistics::shading_ms,
          &Statistics::output_ms, &Statistics::frame_ms}) {
        sum.*member += part.*member;
    }
    for (const auto member : {&Statistics::triangles_in, &Statistics::triangles_not_finite,
                              &Statistics::triangles_visible, &Statistics::fragments_shaded,
                              &Statistics::tiles_empty}) {
        sum.*member += part.*member;
    }
}

}  // namespace

std::vector<PanelOptions> panels_of(const Lesson& lesson, const Options& o) {
    std::vector<PanelOptions> parts;
    const auto count = static_cast<int>(lesson.panels.size());
    for (int i = 0; i < count; ++i) {
        const int left = o.width * i / count;
        PanelOptions part{o, left};
        part.options.width = o.width * (i + 1) / count - left;
        for (const auto& [name, value] : lesson.panels[static_cast<std::size_t>(i)]) {
            if (is_set(lesson, o, name)) {
                return {{o, 0}};
            }
            part.options.parameters.set(name, value);
        }
        parts.push_back(part);
    }
    if (parts.empty() || o.width < count) {
        return {{o, 0}};
    }
    return parts;
}

void add_panel(const Drawing& part, int left, const Options& o, Drawing& whole) {
    if (whole.srgb.empty()) {
        whole.srgb = SrgbImage(o.width, o.height);
        whole.linear = part.linear.empty() ? LinearImage() : LinearImage(o.width, o.height);
        whole.values = part.values.empty() ? Image<float>() : Image<float>(o.width, o.height);
        whole.frames.resize(part.frames.size());
    }
    paste(part.srgb, left, whole.srgb);
    for (int y = 0; y < o.height && left > 0; ++y) {
        whole.srgb(left, y) = line;
    }
    if (!part.linear.empty()) {
        paste(part.linear, left, whole.linear);
    }
    if (!part.values.empty()) {
        paste(part.values, left, whole.values);
    }
    whole.plans.insert(whole.plans.end(), part.plans.begin(), part.plans.end());
    for (std::size_t i = 0; i < part.frames.size(); ++i) {
        add(part.frames[i], whole.frames[i]);
    }
}

Drawing draw_panels(const Lesson& lesson, const Options& o) {
    const std::vector<PanelOptions> parts = panels_of(lesson, o);
    Drawing whole;
    Scene scene;
    for (const auto& [options, left] : parts) {
        scene = left == 0 ? make_scene(lesson, options) : make_scene(lesson, options, scene);
        Drawing part = draw(lesson, options, scene);
        if (parts.size() == 1) {
            return part;
        }
        add_panel(part, left, o, whole);
    }
    return whole;
}

}  // namespace glint
