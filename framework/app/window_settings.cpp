#include "framework/app/window_settings.hpp"

#include "framework/app/window_words.hpp"
#include "framework/raster/samples.hpp"
#include "framework/math/dispatch.hpp"

#include <algorithm>

namespace glint {
namespace {

constexpr float parameter_steps = 50;

int next_lanes(int lanes) {
    do {
        lanes = lanes >= max_lanes ? 1 : lanes + 1;
    } while (!has_lanes(lanes));
    return lanes;
}

bool move(Parameter& p, float steps) {
    const float step = p.whole ? steps : steps * (p.high - p.low) / parameter_steps;
    const float before = p.value;
    // Six digits: there and back again is the same number, else panels would not come back.
    p.value = std::clamp(std::stof(formatted("%.6g", before + step)), p.low, p.high);
    return p.value != before;
}

}  // namespace

bool change_settings(Options& o, Action action) {
    Settings& s = o.settings;
    switch (action) {
        case Action::next_rasterizer:
            s.rasterizer =
                s.rasterizer == Rasterizer::tiles ? Rasterizer::scanline : Rasterizer::tiles;
            return true;
        case Action::next_lanes:
            s.lanes = next_lanes(s.lanes);
            return true;
        case Action::next_samples:
            s.samples = s.samples >= max_samples ? 1 : 2 * s.samples;
            return true;
        case Action::next_culling:
            s.cull = s.cull == Cull::none ? Cull::back : Cull::none;
            return true;
        case Action::view_shaded:
            o.view = ViewMode::shaded;
            return true;
        case Action::view_normal:
            o.view = ViewMode::normal;
            return true;
        case Action::view_depth:
            o.view = ViewMode::depth;
            return true;
        case Action::view_triangle:
            o.view = ViewMode::triangle;
            return true;
        case Action::view_overdraw:
            o.view = ViewMode::overdraw;
            return true;
        case Action::view_tiles:
            o.view = ViewMode::tiles;
            return true;
        default:
            return false;
    }
}

bool change_parameters(Parameters& parameters, std::size_t& chosen, Action action) {
    const std::size_t count = parameters.all().size();
    if (count == 0) {
        return false;
    }
    switch (action) {
        case Action::parameter_next:
            chosen = (chosen + 1) % count;
            return false;
        case Action::parameter_previous:
            chosen = (chosen + count - 1) % count;
            return false;
        case Action::parameter_less:
            return move(parameters.all()[chosen], -1);
        case Action::parameter_more:
            return move(parameters.all()[chosen], 1);
        default:
            return false;
    }
}

}  // namespace glint
