// The picture of the live window, and what keys and mouse do to it.
#pragma once

#include "framework/app/lesson.hpp"
#include "framework/app/panels.hpp"
#include "framework/app/picture.hpp"
#include "framework/app/probe.hpp"
#include "framework/app/window_keys.hpp"
#include "framework/app/window_mouse.hpp"
#include "framework/app/window_words.hpp"
#include "framework/raster/renderer.hpp"

#include <optional>
#include <string>
#include <vector>

namespace glint {

// Always what the lesson program would write for the same options and camera.
class LivePicture {
  public:
    // The lesson must outlive it. Error where the scene cannot be had.
    LivePicture(const Lesson& lesson, const Options& options);

    void resize(int width, int height);
    void act(Action action);           // what moves the camera, settings or parameters
    void act(const Gesture& gesture);  // orbit, pan, and a click that probes
    void zoom_steps(float steps);      // of a mouse wheel, positive is nearer
    void forget_probe();
    void redraw() { stale_ = true; }

    bool stale() const { return stale_; }  // drawing() will differ
    const Drawing& drawing();              // drawn anew where stale
    // What is known of the probed pixel options().probe, of the last drawing.
    const std::optional<PixelReport>& report() const { return report_; }

    const Options& options() const { return options_; }
    Lines status() const;  // of the last drawing, in words
    struct Label {
        int left;           // of a panel
        std::string words;  // the parameters that it differs in
    };
    std::vector<Label> labels() const;  // none where there is one panel

  private:
    struct Part {
        PanelOptions at;
        Scene scene;
        Camera home;
    };

    void arrange();
    void restage();
    Scene scene_of(const Options& options) const;
    void steer(const auto& move);
    void probe();

    const Lesson& lesson_;
    Options options_;
    std::vector<Part> parts_;           // the panels, one at least
    std::optional<Renderer> renderer_;  // none: settings changed
    std::size_t chosen_parameter_ = 0;
    Drawing drawing_;
    std::optional<PixelReport> report_;
    bool stale_ = true;
};

}  // namespace glint
