// Where the live window has its picture from: the lesson in this program, or one in another program
// that may end at any time.
#pragma once

#include "framework/app/options.hpp"
#include "framework/app/window_keys.hpp"
#include "framework/app/window_mouse.hpp"
#include "framework/app/window_words.hpp"
#include "framework/image/image.hpp"

#include <string>
#include <vector>

namespace glint {

// A picture with all that the window says about it.
struct Seen {
    struct Label {
        int left;           // of a panel
        std::string words;  // the parameters that it differs in
    };
    SrgbImage picture;
    Lines status;
    std::vector<Label> labels;  // none where there is one panel
    Lines report;               // of the probed pixel; none where there is none
};

class PictureSource {
  public:
    PictureSource() = default;
    PictureSource(const PictureSource&) = delete;
    PictureSource& operator=(const PictureSource&) = delete;
    virtual ~PictureSource() = default;

    virtual void resize(int width, int height) = 0;
    virtual void act(Action action) = 0;           // what moves the camera, settings or parameters
    virtual void act(const Gesture& gesture) = 0;  // orbit, pan, and a click that probes
    virtual void zoom_steps(float steps) = 0;      // of a mouse wheel, positive is nearer
    virtual void forget_probe() = 0;
    virtual void redraw() = 0;

    virtual bool stale() const = 0;  // what is seen will differ
    virtual const Seen& seen() = 0;  // drawn anew where stale
    virtual const Options& options() const = 0;
};

}  // namespace glint
