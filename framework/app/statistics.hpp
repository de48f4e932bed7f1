// What a drawing took, for people and for programs.
#pragma once

#include "framework/app/picture.hpp"

#include <string>

namespace glint {

// One line: name, size, fragments, nanoseconds a fragment, first picture file.
std::string summary(const Lesson& lesson, const Options& options, const Drawing& drawing);

// One JSON object to the file of --stats, or to standard output: the lesson, least and median
// milliseconds of a frame and of its stages, counts, and what drew it.
void write_statistics(const Lesson& lesson, const Options& options, const Drawing& drawing);

}  // namespace glint
