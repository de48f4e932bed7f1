// The two halves of FLIP, which flip_map() joins: see flip.hpp for the paper.
#pragma once

#include "framework/image/image.hpp"

#include <array>
#include <cmath>

namespace glint::flip {

using Plane = Image<float>;
using Weights = std::vector<float>;
using Opponent = std::array<Plane, 3>;  // Y, Cx and Cz of colour.hpp

// The colour pipeline: the difference of the colours that the eye resolves at this distance, 0..1.
Plane colour_difference(const Opponent& reference, const Opponent& test, float pixels_per_degree);

// The feature pipeline: the difference of edges and points in the achromatic channel Y, 0..1.
Plane feature_difference(const Plane& reference, const Plane& test, float pixels_per_degree);

// The values of function(x) for x = -radius..radius.
template <class Function>
Weights sampled(int radius, const Function& function) {
    Weights weights;
    for (int x = -radius; x <= radius; ++x) {
        weights.push_back(static_cast<float>(function(static_cast<double>(x))));
    }
    return weights;
}

// Positive weights scaled to the sum 1, negative ones to -1: the answer to a step of height 1 is
// the same at every resolution.
inline Weights normalised(Weights weights) {
    double positive = 0.0;
    double negative = 0.0;
    for (const float w : weights) {
        (w > 0.0F ? positive : negative) += std::abs(w);
    }
    for (float& w : weights) {
        w = w == 0.0F ? 0.0F : static_cast<float>(w / (w > 0.0F ? positive : negative));
    }
    return weights;
}

}  // namespace glint::flip
