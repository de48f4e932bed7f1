// What the keys of the live window do.
#pragma once

#include <optional>
#include <span>
#include <string_view>

namespace glint {

enum class Action {
    orbit_left,  // where the eye goes
    orbit_right,
    orbit_up,
    orbit_down,
    pan_left,  // where the picture goes
    pan_right,
    pan_up,
    pan_down,
    zoom_in,
    zoom_out,
    parameter_less,
    parameter_more,
    parameter_previous,
    parameter_next,
    reset_camera,
    next_rasterizer,
    next_lanes,
    next_samples,
    next_culling,
    view_shaded,
    view_normal,
    view_depth,
    view_triangle,
    view_overdraw,
    view_tiles,
    keep_picture,
    show_split,
    show_difference,
    dismiss,
    show_words,
    show_keys,
    save,
    close
};

// The meaning of a key, by the name that its cap has on a US keyboard ("R", "Left", "PageUp").
std::optional<Action> action_of(std::string_view key, bool shift);

// Whether the action goes on while its key is held.
bool repeats(Action action);

struct KeyHelp {
    std::string_view keys, meaning;
};
std::span<const KeyHelp> key_help();

}  // namespace glint
