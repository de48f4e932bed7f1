// Pictures inside the text of other forms.
#pragma once

#include "tests/grading/result.hpp"

namespace glint::grading {

// What the three parts of a picture are.
inline constexpr const char* picture_parts = "as it is to be, yours, the difference";

bool has_picture(const CaseResult& c);

// "data:image/png;base64,...", of a few kilobytes. The case has a picture.
std::string picture_url(const CaseResult& c);

// The coverage of a triangle as lines of signs and what they mean; empty where it is right.
std::string raster_of(const CaseResult& c);

}  // namespace glint::grading
