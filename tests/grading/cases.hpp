// Where the cases of a lesson come from: with the instructor they are made from manifests, with
// students they are stored, the visible ones.
#pragma once

#include "tests/grading/case.hpp"

#include <filesystem>
#include <optional>
#include <string>

namespace glint::grading {

// Whose hidden cases: they follow from a secret, the assignment and the student.
struct Identity {
    std::string secret, assignment, student;
};

// Visible cases are the same for everyone; hidden ones are there where somebody is named. An Error
// where the lesson is not graded, where its manifest is wrong, or where hidden cases are asked for
// that this tree has not.
Lesson cases_of(const std::string& lesson, const std::optional<Identity>& identity);

// The lessons that are graded, in order, and the file that a lesson's cases come from.
std::vector<std::string> graded_lessons();
std::filesystem::path lesson_file(const std::string& lesson);

}  // namespace glint::grading
