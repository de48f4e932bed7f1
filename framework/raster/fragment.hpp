// From the samples that triangles won to fragments: what is shaded, where, and with which weight.
// Both rasterizers resolve pixels by this text.
#pragma once

#include "framework/math/one_lane.hpp"

#include <span>

namespace glint {

// The fragments of one pixel, or of one pixel a lane, given the triangle at each sample (negative:
// none), nearest sample first. Shading is once a pixel and triangle: at the centre where one
// triangle won every sample, else at its sample nearest the centre, so never outside the triangle;
// or once a sample.
//
// Calls add(where, triangle, sample, count) for each sample that a fragment begins with: in which
// pixels, of which triangle, and for how many of the pixel's samples it stands; which is all of
// them where it is shaded at the centre. I is int or lanes of it.
template <class I, class Add>
void resolve_pixels(std::span<const I> won, bool sample_shading, Add&& add) {
    for (std::size_t s = 0; s < won.size(); ++s) {
        auto begins = won[s] >= I(0);
        I count(1);
        if (!sample_shading) {
            for (std::size_t before = 0; before < s; ++before) {
                begins = begins & (won[before] != won[s]);
            }
            for (std::size_t after = s + 1; after < won.size(); ++after) {
                count += select(won[after] == won[s], I(1), I(0));
            }
        }
        if (any(begins)) {
            add(begins, won[s], s, count);
        }
    }
}

}  // namespace glint
