// What the live window says in words, line by line.
#pragma once

#include "framework/app/options.hpp"
#include "framework/app/probe.hpp"
#include "framework/app/window_compare.hpp"
#include "framework/raster/pipeline.hpp"

#include <cstddef>
#include <string>
#include <vector>

namespace glint {

using Lines = std::vector<std::string>;

// Time and time a fragment, what draws it, the view, and the chosen parameter if there is one.
Lines status_lines(const Options& options, const Statistics& frame, std::size_t chosen_parameter);

// A table of the readings: float, double and their difference.
Lines report_lines(const PixelReport& report);

// What each key does.
Lines key_lines();

// How far the picture is from the one of that name.
std::string difference_line(const CodeDifference& difference, const std::string& name);

// printf's format with one number.
std::string formatted(const char* format, double number);

}  // namespace glint
