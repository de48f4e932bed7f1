#include "framework/app/window_picture.hpp"

#include "framework/app/window_camera.hpp"
#include "framework/app/window_settings.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace glint {
namespace {

constexpr float wheel_zoom = 1.1F;  // a step

bool same_place(const Camera& a, const Camera& b) {
    return a.eye == b.eye && a.target == b.target;
}

float usual_distance(const Camera& home) {
    return distance(home.eye, home.target);
}

}  // namespace

LivePicture::LivePicture(const Lesson& lesson, Options options)
    : lesson_(lesson), options_(std::move(options)) {
    restage();
}

void LivePicture::resize(int width, int height) {
    if (width < 1 || height < 1 || (width == options_.width && height == options_.height)) {
        return;
    }
    options_.width = width;
    options_.height = height;
    if (options_.probe && (options_.probe->first >= width || options_.probe->second >= height)) {
        options_.probe.reset();
    }
    arrange();
}

void LivePicture::act(Action action) {
    const int height = options_.height;
    steer([&](const Part& part) {
        return steered(part.scene.camera, action, usual_distance(part.home), height);
    });
    if (change_settings(options_, action)) {
        renderer_.reset();
        arrange();
    }
    if (change_parameters(options_.parameters, chosen_parameter_, action)) {
        restage();
    }
    if (action == Action::reset_camera) {
        for (Part& part : parts_) {
            part.scene.camera = part.home;
        }
        stale_ = true;
    }
}

void LivePicture::act(const Gesture& gesture) {
    const auto x = static_cast<float>(gesture.x);
    const auto y = static_cast<float>(gesture.y);
    const float angle = std::numbers::pi_v<float> / static_cast<float>(options_.height);
    if (gesture.kind == Gesture::Kind::orbit) {
        steer([&](const Part& p) { return orbit(p.scene.camera, -angle * x, angle * y); });
    } else if (gesture.kind == Gesture::Kind::pan) {
        steer([&](const Part& p) { return pan(p.scene.camera, x, y, options_.height); });
    } else if (gesture.kind == Gesture::Kind::click) {
        options_.probe = {std::clamp(gesture.x, 0, options_.width - 1),
                          std::clamp(gesture.y, 0, options_.height - 1)};
        stale_ = true;
    }
}

void LivePicture::zoom_steps(float steps) {
    const float factor = std::pow(wheel_zoom, -steps);
    steer([&](const Part& p) { return zoom(p.scene.camera, factor, usual_distance(p.home)); });
}

void LivePicture::forget_probe() {
    options_.probe.reset();
    report_.reset();
}

const Drawing& LivePicture::drawing() {
    if (!stale_) {
        return drawing_;
    }
    if (!renderer_) {
        renderer_.emplace(settings_for(options_));
    }
    Drawing whole;
    for (const auto& [at, scene, home] : parts_) {
        const ShaderSet shading = lesson_.shaders(scene, at.options.parameters);
        const View view = view_of(scene, at.options.width, at.options.height);
        Drawing part = draw_view(options_.view, *renderer_, scene, view, shading.shaders, false);
        if (parts_.size() == 1) {
            whole = std::move(part);
        } else {
            add_panel(part, at.left, options_, whole);
        }
    }
    drawing_ = std::move(whole);
    probe();
    stale_ = false;
    return drawing_;
}

const Seen& LivePicture::seen() {
    if (stale_) {
        seen_.picture = drawing().srgb;
    }
    seen_.status = status();
    seen_.labels = labels();
    seen_.report = report_ ? report_lines(*report_) : Lines{};
    return seen_;
}

PictureState LivePicture::state() const {
    const auto [x, y] = options_.probe.value_or(std::pair(-1, -1));
    PictureState s{options_.width,
                   options_.height,
                   options_.settings,
                   options_.view,
                   x,
                   y,
                   chosen_parameter_,
                   {},
                   {}};
    for (const Parameter& p : options_.parameters.all()) {
        s.parameters.push_back(p.value);
    }
    for (const Part& part : parts_) {
        s.views.push_back({!same_place(part.scene.camera, part.home), part.scene.camera});
    }
    return s;
}

void LivePicture::restore(const PictureState& s) {
    options_.width = s.width;
    options_.height = s.height;
    options_.settings = s.settings;
    options_.view = s.view;
    options_.probe.reset();
    if (s.probe_x >= 0) {
        options_.probe = {s.probe_x, s.probe_y};
    }
    if (s.parameters.size() == options_.parameters.all().size()) {
        chosen_parameter_ = s.chosen_parameter;
        for (std::size_t i = 0; i < s.parameters.size(); ++i) {
            options_.parameters.all()[i].value = s.parameters[i];
        }
    }
    renderer_.reset();
    restage();
    for (std::size_t i = 0; i < parts_.size() && i < s.views.size(); ++i) {
        if (s.views[i].moved) {
            parts_[i].scene.camera = s.views[i].camera;
        }
    }
}

Lines LivePicture::status() const {
    return status_lines(options_, drawing_.frames.front(), chosen_parameter_);
}

std::vector<Seen::Label> LivePicture::labels() const {
    std::vector<Seen::Label> labels;
    for (std::size_t i = 0; i < parts_.size() && parts_.size() > 1; ++i) {
        std::string words;
        for (const auto& [name, value] : lesson_.panels[i]) {
            words += (words.empty() ? "" : ", ") + name + formatted(" = %.4g", value);
        }
        labels.push_back({parts_[i].at.left, words});
    }
    return labels;
}

void LivePicture::probe() {
    report_.reset();
    if (!options_.probe) {
        return;
    }
    const auto [x, y] = *options_.probe;
    const auto after =
        std::ranges::find_if(parts_, [x = x](const Part& part) { return part.at.left > x; });
    const Part& part = *std::prev(after);
    Options options = part.at.options;
    options.probe = {x - part.at.left, y};
    report_ = probe_pixel(lesson_, options, part.scene);
}

// move(part) is the camera that a part shall have.
void LivePicture::steer(const auto& move) {
    for (Part& part : parts_) {
        const Camera camera = move(std::as_const(part));
        if (!same_place(camera, part.scene.camera)) {
            part.scene.camera = with_depth_range(camera, part.scene.mesh, options_);
            stale_ = true;
        }
    }
}

// Size or settings changed: the scenes stay what they are.
void LivePicture::arrange() {
    std::vector<PanelOptions> panels = panels_of(lesson_, options_);
    if (panels.size() != parts_.size()) {
        return restage();
    }
    for (std::size_t i = 0; i < parts_.size(); ++i) {
        parts_[i].at = std::move(panels[i]);
    }
    stale_ = true;
}

// Parameters changed, or the number of panels. A camera stays where the user took it.
void LivePicture::restage() {
    std::vector<Part> parts;
    for (PanelOptions& at : panels_of(lesson_, options_)) {
        const std::size_t i = std::min(parts.size(), parts_.size() - 1);
        Scene scene = parts_.empty() ? make_scene(lesson_, at.options)
                                     : make_scene(lesson_, at.options, parts_.front().scene);
        const Camera home = scene.camera;
        if (!parts_.empty() && !same_place(parts_[i].scene.camera, parts_[i].home)) {
            scene.camera = parts_[i].scene.camera;
        }
        parts.push_back({std::move(at), std::move(scene), home});
    }
    parts_ = std::move(parts);
    stale_ = true;
}

}  // namespace glint
