#include "framework/geometry/bezier_patch.hpp"

namespace glint {
namespace {

using Weights = std::array<double, 4>;

Weights bernstein(double t) {
    const double s = 1.0 - t;
    return {s * s * s, 3.0 * s * s * t, 3.0 * s * t * t, t * t * t};
}

Weights bernstein_derivative(double t) {
    const double s = 1.0 - t;
    return {-3.0 * s * s, 3.0 * s * (s - 2.0 * t), 3.0 * t * (2.0 * s - t), 3.0 * t * t};
}

glm::dvec3 weighted(const BicubicPatch& patch, const Weights& along_u, const Weights& along_v) {
    glm::dvec3 sum(0.0);
    for (std::size_t row = 0; row < 4; ++row) {
        for (std::size_t column = 0; column < 4; ++column) {
            sum += along_v[row] * along_u[column] * patch.control[row][column];
        }
    }
    return sum;
}

}  // namespace

glm::dvec3 point(const BicubicPatch& patch, double u, double v) {
    return weighted(patch, bernstein(u), bernstein(v));
}

glm::dvec3 normal(const BicubicPatch& patch, double u, double v) {
    glm::dvec3 along_u = weighted(patch, bernstein_derivative(u), bernstein(v));
    const glm::dvec3 along_v = weighted(patch, bernstein(u), bernstein_derivative(v));
    if (dot(along_u, along_u) < 1e-20 * dot(along_v, along_v)) {
        // dS/du is about (v - v0) d2S/dudv beside the pole v0
        along_u = weighted(patch, bernstein_derivative(u), bernstein_derivative(v));
        along_u *= v < 0.5 ? 1.0 : -1.0;
    }
    return normalize(cross(along_u, along_v));
}

}  // namespace glint
