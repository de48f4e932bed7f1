// Takes a header out of a zip archive, which may be anything: a confined unzip reads it, and only
// the header's text comes out. Nothing is unpacked into any folder.
#pragma once

#include "tests/grading/intake.hpp"

namespace glint::grading {

// By its name, in capitals or not.
bool is_archive(const std::filesystem::path& file);

// The one member of that name, in whatever folder of the archive.
Intake take_from_archive(const std::filesystem::path& archive, const std::string& name);

}  // namespace glint::grading
