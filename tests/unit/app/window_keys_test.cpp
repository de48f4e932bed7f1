#include "framework/app/window_keys.hpp"

#include <doctest/doctest.h>

#include <array>
#include <set>
#include <string>

namespace glint {
namespace {

// As SDL names them.
constexpr std::array<const char*, 38> keys{
    "Left", "Right",  "Up",       "Down",     "PageUp", "PageDown", "Home", "Tab", "[", "]",
    "-",    "=",      "+",        "R",        "T",      "L",        "M",    "C",   "1", "2",
    "3",    "4",      "5",        "6",        "K",      "V",        "D",    "S",   "H", "Q",
    "F1",   "Escape", "Keypad -", "Keypad +", "A",      "Return",   "7",    ""};

TEST_CASE("every action has a key") {
    std::set<Action> reached;
    for (const char* key : keys) {
        for (const bool shift : {false, true}) {
            if (const auto action = action_of(key, shift)) {
                reached.insert(*action);
            }
        }
    }
    CHECK(reached.size() == static_cast<std::size_t>(Action::close) + 1);
}

TEST_CASE("shift pans where the key alone orbits, and does not disturb the others") {
    CHECK(action_of("Left", false) == Action::orbit_left);
    CHECK(action_of("Left", true) == Action::pan_left);
    CHECK(action_of("Tab", false) == Action::parameter_next);
    CHECK(action_of("Tab", true) == Action::parameter_previous);
    CHECK(action_of("=", true) == Action::parameter_more);
    CHECK(action_of("R", true) == Action::reset_camera);
    CHECK(action_of("R", false) == action_of("Home", false));
}

TEST_CASE("other keys do nothing") {
    for (const char* key : {"", "A", "7", "Return", "r"}) {
        CHECK_FALSE(action_of(key, false));
        CHECK_FALSE(action_of(key, true));
    }
}

TEST_CASE("what moves bit by bit goes on while its key is held, a switch does not") {
    for (const Action action : {Action::orbit_left, Action::pan_down, Action::zoom_out,
                                Action::parameter_less, Action::parameter_more}) {
        CHECK(repeats(action));
    }
    for (const Action action : {Action::parameter_next, Action::next_rasterizer, Action::save,
                                Action::show_words, Action::close}) {
        CHECK_FALSE(repeats(action));
    }
}

TEST_CASE("the help names every key that is one letter or digit") {
    std::string named = " ";
    for (const KeyHelp& line : key_help()) {
        named += std::string(line.keys) + " ";
    }
    for (const char* key : keys) {
        const std::string name = key;
        if (name.size() == 1 && name != "=" && action_of(name, false)) {
            CAPTURE(name);
            CHECK(named.find(" " + name + " ") != std::string::npos);
        }
    }
}

}  // namespace
}  // namespace glint
