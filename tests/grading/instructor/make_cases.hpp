// From a manifest to the cases of one student.
#pragma once

#include "tests/grading/case.hpp"

#include <optional>
#include <string>

namespace glint::grading {

// Whose hidden cases: they follow from a secret, the assignment and the student.
struct Identity {
    std::string secret, assignment, student;
};

// A lesson's cases by manifests/NAME.json; visible ones are the same for everyone, hidden ones are
// there where somebody is named. An Error where there is no such manifest, or it is wrong.
Lesson make_cases(const std::string& lesson, const std::optional<Identity>& identity);

// The lessons that have a manifest, in order.
std::vector<std::string> graded_lessons();

}  // namespace glint::grading
