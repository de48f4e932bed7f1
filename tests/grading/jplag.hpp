// Hands a class to JPlag, which compares programs: it says what is alike, people say what that
// means.
#pragma once

#include "tests/grading/class.hpp"

namespace glint::grading {

// Writes c.out/submissions/STUDENT/HEADER for all that was handed in and can be read, and from the
// students' tree what everyone was given, c.out/base/HEADER. All or nothing; an Error where c.out
// is there already, or where the students' tree lacks a header.
void export_for_jplag(const ClassOrder& c, const std::filesystem::path& students_tree);

}  // namespace glint::grading
