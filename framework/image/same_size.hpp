// Pictures can be compared where each pixel of one has its counterpart in the other.
#pragma once

#include "framework/image/image.hpp"
#include "framework/math/error.hpp"

#include <string>

namespace glint {

// Error where the sizes differ or nothing is there.
template <class Pixel>
void require_same_size(const Image<Pixel>& reference, const Image<Pixel>& test) {
    const auto size = [](const Image<Pixel>& image) {
        return std::to_string(image.width()) + "x" + std::to_string(image.height());
    };
    if (reference.width() != test.width() || reference.height() != test.height()) {
        throw Error("the reference has " + size(reference) + " pixels, the test picture " +
                    size(test) + ": they must be of one size");
    }
    if (reference.empty()) {
        throw Error("the pictures are empty");
    }
}

}  // namespace glint
