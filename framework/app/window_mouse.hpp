// What a hand does with the mouse: a press, moves and a release become an orbit, a pan, a move of
// the split line, or a click.
#pragma once

namespace glint {

enum class MouseButton { left, middle, right };

struct Gesture {
    enum class Kind { none, orbit, pan, split, click };
    Kind kind = Kind::none;
    int x = 0, y = 0;  // orbit and pan: pixels moved right and down; split and click: the place
    friend bool operator==(const Gesture&, const Gesture&) = default;
};

class Mouse {
  public:
    // Of several buttons the one pressed first counts, until it is released.
    void press(MouseButton button, bool shift, bool on_split_line, int x, int y);
    Gesture move(int x, int y);
    Gesture release(MouseButton button, int x, int y);
    bool pressed() const { return drag_ != Gesture::Kind::none; }

  private:
    Gesture::Kind drag_ = Gesture::Kind::none;
    MouseButton button_ = MouseButton::left;
    bool moved_ = false;  // far enough to be no click
    int x_ = 0, y_ = 0;
};

}  // namespace glint
