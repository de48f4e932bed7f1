// Grades a class: a folder that holds a folder or a zip archive for each student.
#pragma once

#include "tests/grading/students.hpp"
#include "tests/grading/submission.hpp"

#include <set>

namespace glint::grading {

struct ClassOrder {
    Order order;  // whose student is each in turn
    std::filesystem::path folder, out;
    std::filesystem::path roster;  // may be empty
    int jobs = 1;
    int part = 0, parts = 1;  // of the students, to be graded on several machines
};

// Writes for each student out/STUDENT/report.json and .html; what is there and still true is kept,
// so that a class goes on where it was stopped. Returns the students whose grading failed: what is
// there of them is not to be trusted.
std::set<std::string> grade_class(const ClassOrder& c);

// Writes out/grades.csv and out/statistics.csv of the reports that are there; returns the students
// of whom there is no final grade.
std::set<std::string> sum_up(const ClassOrder& c);

}  // namespace glint::grading
