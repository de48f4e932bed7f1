// Whole files as text.
#pragma once

#include <filesystem>
#include <string>

namespace glint::grading {

// An Error where it cannot be read.
std::string read_text(const std::filesystem::path& path);

// Beside it first, then renamed: nobody ever sees half a file. An Error where it cannot be written.
void write_text(const std::filesystem::path& path, const std::string& text);

}  // namespace glint::grading
