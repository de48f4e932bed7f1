// The worse of two errors.
#pragma once

#include <limits>

namespace glint {

// Infinity where one is NaN, which std::max() would pass over.
inline double worse(double a, double b) {
    return a >= b ? a : b >= a ? b : std::numeric_limits<double>::infinity();
}

}  // namespace glint
