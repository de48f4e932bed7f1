// What is charted: a file each in families/.
#pragma once

#include "docs/charts/harness.hpp"

namespace glint::charts {

std::vector<Contender> pow_contenders();
std::vector<Contender> normalise_contenders();
std::vector<Contender> fresnel_contenders();
std::vector<Contender> srgb_contenders();
std::vector<Contender> interpolation_contenders();
std::vector<Contender> shading_contenders();
std::vector<Contender> number_type_contenders();
std::vector<Contender> antialiasing_contenders();
std::vector<Contender> captured_contenders();
std::vector<Contender> frames_contenders();

}  // namespace glint::charts
