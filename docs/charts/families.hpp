// What is charted: a file each in families/.
#pragma once

#include "docs/charts/harness.hpp"

namespace glint::charts {

std::vector<Contender> pow_contenders();
std::vector<Contender> normalise_contenders();
std::vector<Contender> fresnel_contenders();
std::vector<Contender> srgb_contenders();

}  // namespace glint::charts
