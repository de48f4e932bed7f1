// The live window's picture, drawn by another process of the same program: it may crash, hang or be
// built anew, and the window stays as it is.
#pragma once

#include "framework/app/window_parcel.hpp"

#include <sys/types.h>

namespace glint {

class RemotePicture final : public PictureSource {
  public:
    // Starts the program with the arguments of this one.
    explicit RemotePicture(Options options);
    ~RemotePicture() override;

    // Goes on with the program as it is on disk now; camera and all else stay.
    void restart();

    void resize(int width, int height) override;
    void act(Action action) override;
    void act(const Gesture& gesture) override;
    void zoom_steps(float steps) override;
    void forget_probe() override;
    void redraw() override;

    bool stale() const override { return stale_; }
    const Seen& seen() override;
    const Options& options() const override { return options_; }

  private:
    void note(const PictureEvent& event);
    void start();
    int stop();
    void give_up(bool in_time);
    void ask();
    void fit();

    Options options_;
    pid_t program_ = -1;  // none where it ended
    int socket_ = -1;
    bool fresh_ = true;                   // knows nothing of the user yet
    std::optional<PictureState> state_;   // of the last picture
    std::vector<PictureEvent> events_{};  // since then
    Seen seen_;
    bool stale_ = true;
};

// Is this the program that draws for a window, and not the one that has it?
bool draws_for_window();

// Is its picture to be drawn by another process? Where the environment says GLINT_WATCH=window.
bool window_is_watched();

// Draws what is asked for until the window is gone; returns main()'s exit code.
int draw_for_window(const Lesson& lesson, const Options& options);

}  // namespace glint
