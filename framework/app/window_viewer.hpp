// What the live window shows: the picture, compared with another, with words over it. Knows no
// window system, so that a test can be its user.
#pragma once

#include "framework/app/lesson.hpp"
#include "framework/app/window_keys.hpp"
#include "framework/app/window_mouse.hpp"
#include "framework/app/window_source.hpp"

#include <memory>
#include <string>

namespace glint {

class Viewer {
  public:
    // Starts as the options say, a split line in the middle where they name a picture to compare
    // with. Error: that picture is not of options.width x options.height, or there is no scene.
    Viewer(const Lesson& lesson, const Options& options);
    // The same with a picture from elsewhere.
    Viewer(std::unique_ptr<PictureSource> source, const Options& options);

    void resize(int width, int height);
    void act(Action action);
    void act(const Gesture& gesture);
    void zoom_steps(float steps);  // of a mouse wheel, positive is nearer
    void redraw();                 // the same again
    void say(const Lines& lines);  // below the words about the picture, until said otherwise

    bool closed() const { return closed_; }
    bool stale() const { return stale_ || live_->stale(); }  // frame() will differ
    bool on_split_line(int x) const;                         // near enough to take hold of it

    // What the window shows, drawn anew where something changed.
    const SrgbImage& frame();
    // The picture alone, without words and comparison.
    const SrgbImage& picture();
    const Options& options() const { return live_->options(); }

  private:
    enum class Comparison { none, split, difference };

    void compare(Comparison wanted);
    void keep();
    void save();
    void dismiss();
    bool comparable() const;
    int split_column() const;

    void compose();
    Lines words(const std::string& about_difference) const;
    void draw_labels();
    void draw_report(int below);

    std::unique_ptr<PictureSource> live_;
    SrgbImage kept_;  // to compare with
    std::string kept_name_;
    Comparison comparison_ = Comparison::none;
    float split_ = 0.5F;   // of the width
    std::string message_;  // about the last action
    Lines said_;
    SrgbImage frame_;
    bool show_words_ = true;
    bool show_keys_ = false;
    bool closed_ = false;
    bool stale_ = true;
};

}  // namespace glint
