// Where questions are drawn from, by the names that manifests use.
#pragma once

#include "tests/grading/instructor/random.hpp"

#include <nlohmann/json_fwd.hpp>

#include <vector>

namespace glint::grading {

// Appends the numbers of one domain: [low, high] is one number between, {"integer": [low, high]} a
// whole one; the names are
//     cosine 1, angle 1 (0..90 degrees, radians), exponent 1, index 1, metal 2 (ior, k), either 1,
//     colour 3, direction 3 (unit), incidence 3 (both directions above the horizon),
//     lobe 4 (an incidence in a lobe, and the lobe's exponent),
//     highlight 10 (normal, light, viewer, exponent), lattice 8 (triangle and point, 0..4)
// Another name is an Error.
void draw(const nlohmann::json& domain, Random& random, std::vector<double>& numbers);

}  // namespace glint::grading
