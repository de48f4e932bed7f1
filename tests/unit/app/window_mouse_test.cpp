#include "framework/app/window_mouse.hpp"

#include <doctest/doctest.h>

#include <initializer_list>

namespace glint {
namespace {

using Kind = Gesture::Kind;

TEST_CASE("a press and release in one place is a click, though the hand trembles") {
    Mouse mouse;
    mouse.press(MouseButton::left, false, false, 50, 60);
    CHECK(mouse.move(52, 59) == Gesture{});
    CHECK(mouse.release(MouseButton::left, 53, 60) == Gesture{Kind::click, 53, 60});
    CHECK_FALSE(mouse.pressed());
}

TEST_CASE("a left drag orbits by what it moved in all, and is no click") {
    Mouse mouse;
    mouse.press(MouseButton::left, false, false, 50, 60);
    CHECK(mouse.move(52, 60) == Gesture{});
    CHECK(mouse.move(58, 57) == Gesture{Kind::orbit, 8, -3});
    CHECK(mouse.move(59, 57) == Gesture{Kind::orbit, 1, 0});
    CHECK(mouse.move(50, 60) == Gesture{Kind::orbit, -9, 3});
    CHECK(mouse.release(MouseButton::left, 50, 60) == Gesture{});
}

TEST_CASE("the other buttons pan, and so does shift") {
    for (const MouseButton button : {MouseButton::right, MouseButton::middle}) {
        Mouse mouse;
        mouse.press(button, false, false, 0, 0);
        CHECK(mouse.move(0, 10) == Gesture{Kind::pan, 0, 10});
        CHECK(mouse.release(button, 0, 10) == Gesture{});
    }
    Mouse mouse;
    mouse.press(MouseButton::left, true, false, 0, 0);
    CHECK(mouse.move(0, 10) == Gesture{Kind::pan, 0, 10});
    CHECK(mouse.release(MouseButton::left, 0, 10) == Gesture{});
    mouse.press(MouseButton::right, false, false, 0, 0);
    CHECK(mouse.release(MouseButton::right, 0, 0) == Gesture{});
}

TEST_CASE("on the split line the left button moves it, at once") {
    Mouse mouse;
    mouse.press(MouseButton::left, false, true, 50, 60);
    CHECK(mouse.move(51, 60) == Gesture{Kind::split, 51, 60});
    CHECK(mouse.move(10, 0) == Gesture{Kind::split, 10, 0});
    CHECK(mouse.release(MouseButton::left, 10, 0) == Gesture{});
    mouse.press(MouseButton::right, false, true, 50, 60);
    CHECK(mouse.move(60, 60) == Gesture{Kind::pan, 10, 0});
}

TEST_CASE("the button pressed first counts") {
    Mouse mouse;
    mouse.press(MouseButton::left, false, false, 0, 0);
    mouse.press(MouseButton::right, false, false, 5, 5);
    CHECK(mouse.release(MouseButton::right, 5, 5) == Gesture{});
    CHECK(mouse.move(10, 0) == Gesture{Kind::orbit, 10, 0});
    CHECK(mouse.release(MouseButton::left, 10, 0) == Gesture{});
    CHECK(mouse.move(20, 0) == Gesture{});
}

}  // namespace
}  // namespace glint
