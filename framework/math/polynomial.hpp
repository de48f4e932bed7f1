// Polynomials by Horner's rule: the fewest roundings and instructions.
#pragma once

#include "framework/math/vec.hpp"

namespace glint {

// c0 + c1 x + c2 x^2 + ...
template <Real T>
T polynomial(T, float c0) {
    return T(c0);
}
template <Real T, class... Coefficients>
T polynomial(T x, float c0, Coefficients... c) {
    return fma(polynomial(x, c...), x, T(c0));
}

}  // namespace glint
