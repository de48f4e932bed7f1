// Answers as pictures, beside what they are to be.
#pragma once

#include "tests/grading/case.hpp"
#include "tests/grading/result.hpp"

#include <span>

namespace glint::grading {

// Of a batch that has a frame. A case of the kind "coverage" is a raster, any other one a picture:
// of one answer a row in grey, of three in colours.
Shown show(const Case& asked, const Batch& batch, std::span<const double> answers);

// The check that fails by what is seen best, and "pixel 3,4" for its place.
std::size_t worst_failure(const Batch& batch, std::span<const double> answers);
std::string place_of(const Batch& batch, std::size_t check);

}  // namespace glint::grading
