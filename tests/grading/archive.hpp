// Takes a header out of a zip archive, which may be anything: a confined unzip reads it, and only
// the header's text comes out. Nothing is unpacked into any folder.
#pragma once

#include "tests/grading/intake.hpp"

namespace glint::grading {

// By its name, in capitals or not.
bool is_archive(const std::filesystem::path& file);

// Whether the program that reads archives is installed.
bool can_unzip();

// The one member of that name, in whatever folder of the archive. An Error where there is no unzip.
Intake take_from_archive(const std::filesystem::path& archive, const std::string& name);

}  // namespace glint::grading
