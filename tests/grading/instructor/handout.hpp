// Writes the students' tree from the instructor's.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace glint::grading {

// Copies the tree at from to the folder to, which must not be there or be empty: answers become
// skeletons, what only instructors see stays, and so does what git does not know; links to it
// become words; visible cases go to tests/grading/cases. Any fault is an Error, and nothing is left
// at to.
void hand_out(const std::filesystem::path& from, const std::filesystem::path& to);

// Lines of the tree's answers that say enough to be recognised, without the spaces around them.
std::vector<std::string> telling_lines(const std::filesystem::path& from);

}  // namespace glint::grading
