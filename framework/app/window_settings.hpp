// What the keys change about how the live window draws.
#pragma once

#include "framework/app/options.hpp"
#include "framework/app/window_keys.hpp"

#include <cstddef>

namespace glint {

// The next rasterizer, lanes that the build has, samples or culling, or the view of the action.
// False, and nothing changed, where the action is about something else.
bool change_settings(Options& options, Action action);

// Chooses a parameter, the first after the last, or moves the chosen one by a fiftieth of its
// range (by one where it takes whole numbers), within its limits. Returns whether a value changed.
bool change_parameters(Parameters& parameters, std::size_t& chosen, Action action);

}  // namespace glint
