#include "framework/app/window_keys.hpp"

#include <algorithm>
#include <array>

namespace glint {
namespace {

struct Binding {
    std::string_view key;
    Action action;
    bool shift = false;  // only with shift; other bindings do not mind it
};

constexpr std::array bindings{
    Binding{"Left", Action::pan_left, true},
    Binding{"Right", Action::pan_right, true},
    Binding{"Up", Action::pan_up, true},
    Binding{"Down", Action::pan_down, true},
    Binding{"Tab", Action::parameter_previous, true},
    Binding{"Left", Action::orbit_left},
    Binding{"Right", Action::orbit_right},
    Binding{"Up", Action::orbit_up},
    Binding{"Down", Action::orbit_down},
    Binding{"PageUp", Action::zoom_in},
    Binding{"PageDown", Action::zoom_out},
    Binding{"-", Action::parameter_less},
    Binding{"Keypad -", Action::parameter_less},
    Binding{"+", Action::parameter_more},
    Binding{"=", Action::parameter_more},
    Binding{"Keypad +", Action::parameter_more},
    Binding{"[", Action::parameter_previous},
    Binding{"]", Action::parameter_next},
    Binding{"Tab", Action::parameter_next},
    Binding{"R", Action::reset_camera},
    Binding{"Home", Action::reset_camera},
    Binding{"T", Action::next_rasterizer},
    Binding{"L", Action::next_lanes},
    Binding{"M", Action::next_samples},
    Binding{"C", Action::next_culling},
    Binding{"1", Action::view_shaded},
    Binding{"2", Action::view_normal},
    Binding{"3", Action::view_depth},
    Binding{"4", Action::view_triangle},
    Binding{"5", Action::view_overdraw},
    Binding{"6", Action::view_tiles},
    Binding{"K", Action::keep_picture},
    Binding{"V", Action::show_split},
    Binding{"D", Action::show_difference},
    Binding{"Escape", Action::dismiss},
    Binding{"H", Action::show_words},
    Binding{"F1", Action::show_keys},
    Binding{"S", Action::save},
    Binding{"Q", Action::close},
};

constexpr std::array help{
    KeyHelp{"drag, arrows", "orbit"},
    KeyHelp{"right drag, shift+arrows", "pan"},
    KeyHelp{"wheel, PageUp PageDown", "zoom"},
    KeyHelp{"R or Home", "camera as at the start"},
    KeyHelp{"[ ] or Tab", "choose a parameter"},
    KeyHelp{"- +", "change it"},
    KeyHelp{"1 2 3", "view shaded, normal, depth"},
    KeyHelp{"4 5 6", "view triangle, overdraw, tiles"},
    KeyHelp{"T", "rasterizer: tiles, scanline"},
    KeyHelp{"L M C", "lanes, samples, culling"},
    KeyHelp{"click", "explain a pixel"},
    KeyHelp{"K", "keep this picture to compare with"},
    KeyHelp{"V", "split line between both: drag it"},
    KeyHelp{"D", "difference of both"},
    KeyHelp{"Esc", "put away keys, pixel, comparison"},
    KeyHelp{"S", "save the picture"},
    KeyHelp{"H F1", "words, these keys"},
    KeyHelp{"Q", "quit"},
};

}  // namespace

std::optional<Action> action_of(std::string_view key, bool shift) {
    const auto* const found = std::ranges::find_if(
        bindings, [&](const Binding& b) { return b.key == key && (shift || !b.shift); });
    return found == bindings.end() ? std::nullopt : std::optional(found->action);
}

bool repeats(Action action) {
    return action <= Action::parameter_more;
}

std::span<const KeyHelp> key_help() {
    return help;
}

}  // namespace glint
