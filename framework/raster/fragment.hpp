// From the samples that triangles won to fragments: what is shaded, where, and with which weight.
// Both rasterizers resolve pixels by this text.
#pragma once

#include "framework/raster/samples.hpp"

#include <array>
#include <cstdint>

namespace glint {

struct Fragment {
    std::int32_t triangle;  // as the caller numbers them
    SampleOffset at;        // where it is shaded, from the pixel's centre
    int samples;            // how many of the pixel's samples it stands for
};

// The fragments of one pixel, given the triangle at each sample (negative: none), nearest sample
// first. Shading is once a pixel and triangle: at the centre where one triangle won every sample,
// else at its sample nearest the centre, so never outside the triangle; or once a sample.
// Returns how many were written.
inline int resolve_pixel(const std::array<std::int32_t, max_samples>& won,
                         std::span<const SampleOffset> offsets, bool sample_shading,
                         std::array<Fragment, max_samples>& out) {
    int count = 0;
    for (std::size_t s = 0; s < offsets.size(); ++s) {
        if (won[s] < 0) {
            continue;
        }
        int known = 0;
        while (!sample_shading && known < count &&
               out[static_cast<std::size_t>(known)].triangle != won[s]) {
            ++known;
        }
        if (sample_shading || known == count) {
            out[static_cast<std::size_t>(count++)] = {won[s], offsets[s], 1};
        } else {
            ++out[static_cast<std::size_t>(known)].samples;
        }
    }
    if (count == 1 && out[0].samples == static_cast<int>(offsets.size())) {
        out[0].at = {0, 0};
    }
    return count;
}

}  // namespace glint
