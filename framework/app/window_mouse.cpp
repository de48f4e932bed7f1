#include "framework/app/window_mouse.hpp"

#include <algorithm>
#include <cstdlib>

namespace glint {
namespace {

constexpr int tremble = 3;  // pixels that a hand may move while it clicks

}  // namespace

void Mouse::press(MouseButton button, bool shift, bool on_split_line, int x, int y) {
    if (pressed()) {
        return;
    }
    const bool left = button == MouseButton::left;
    drag_ = left && on_split_line ? Gesture::Kind::split
            : left && !shift      ? Gesture::Kind::orbit
                                  : Gesture::Kind::pan;
    button_ = button;
    moved_ = drag_ == Gesture::Kind::split;
    x_ = x;
    y_ = y;
}

Gesture Mouse::move(int x, int y) {
    if (!pressed()) {
        return {};
    }
    moved_ = moved_ || std::max(std::abs(x - x_), std::abs(y - y_)) > tremble;
    if (!moved_) {
        return {};
    }
    if (drag_ == Gesture::Kind::split) {
        return {drag_, x, y};
    }
    const Gesture gesture{drag_, x - x_, y - y_};
    x_ = x;
    y_ = y;
    return gesture;
}

Gesture Mouse::release(MouseButton button, int x, int y) {
    if (!pressed() || button != button_) {
        return {};
    }
    const bool click = drag_ == Gesture::Kind::orbit && !moved_;
    drag_ = Gesture::Kind::none;
    return click ? Gesture{Gesture::Kind::click, x, y} : Gesture{};
}

}  // namespace glint
