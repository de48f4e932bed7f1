// Grades one header of one student, from the file to the points.
#pragma once

#include "tests/grading/intake.hpp"
#include "tests/grading/score.hpp"

namespace glint::grading {

// Never throws: what goes wrong on the grader's side is the verdict internal_error. The lessons
// before it and the framework are those of the tree at root.
LessonResult grade_lesson(const Lesson& lesson, const Intake& submitted,
                          const std::filesystem::path& root);

// The header of a lesson in what was handed in: the file itself, a file in a folder, one in a tree
// as Glint's.
Intake find_header(const std::filesystem::path& submission, const Lesson& lesson);

}  // namespace glint::grading
