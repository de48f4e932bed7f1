// The picture of the live window, and what keys and mouse do to it.
#pragma once

#include "framework/app/lesson.hpp"
#include "framework/app/panels.hpp"
#include "framework/app/picture.hpp"
#include "framework/app/probe.hpp"
#include "framework/app/window_keys.hpp"
#include "framework/app/window_mouse.hpp"
#include "framework/app/window_source.hpp"
#include "framework/raster/renderer.hpp"

#include <optional>
#include <vector>

namespace glint {

// What the user did to a picture, to be done to another one of the same lesson.
struct PictureState {
    struct View {
        bool moved;  // from where the lesson has it
        Camera camera;
    };
    int width, height;
    Settings settings;
    ViewMode view;
    int probe_x, probe_y;  // -1: none
    std::size_t chosen_parameter;
    std::vector<float> parameters;
    std::vector<View> views;  // of the panels
};

// Always what the lesson program would write for the same options and camera.
class LivePicture final : public PictureSource {
  public:
    // The lesson must outlive it. Error where the scene cannot be had.
    LivePicture(const Lesson& lesson, Options options);

    void resize(int width, int height) override;
    void act(Action action) override;
    void act(const Gesture& gesture) override;
    void zoom_steps(float steps) override;
    void forget_probe() override;
    void redraw() override { stale_ = true; }

    PictureState state() const;
    // Of the same lesson, which may have other parameters or panels now: these stay as they are.
    void restore(const PictureState& state);

    bool stale() const override { return stale_; }
    const Seen& seen() override;
    const Drawing& drawing();  // drawn anew where stale
    // What is known of the probed pixel options().probe, of the last drawing.
    const std::optional<PixelReport>& report() const { return report_; }

    const Options& options() const override { return options_; }
    Lines status() const;  // of the last drawing, in words
    std::vector<Seen::Label> labels() const;

  private:
    struct Part {
        PanelOptions at;
        Scene scene;
        Camera home;
    };

    void arrange();
    void restage();
    void steer(const auto& move);
    void probe();

    const Lesson& lesson_;
    Options options_;
    std::vector<Part> parts_;           // the panels, one at least
    std::optional<Renderer> renderer_;  // none: settings changed
    std::size_t chosen_parameter_ = 0;
    Drawing drawing_;
    std::optional<PixelReport> report_;
    Seen seen_;
    bool stale_ = true;
};

}  // namespace glint
