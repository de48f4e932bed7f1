// Grades a class: a folder that holds a folder or a zip archive for each student.
#pragma once

#include "tests/grading/submission.hpp"

namespace glint::grading {

struct ClassOrder {
    Order order;  // whose student is each in turn
    std::filesystem::path folder, out;
    std::filesystem::path roster;  // a CSV whose first column names the students; may be empty
    int jobs = 1;
    int part = 0, parts = 1;  // of the students, to be graded on several machines
};

// Writes for each student out/STUDENT/report.json and .html; what is there and still true is kept,
// so that a class goes on where it was stopped. With all parts there, writes out/grades.csv and
// out/statistics.csv and returns the students of whom there is no final grade.
std::vector<std::string> grade_class(const ClassOrder& c);

}  // namespace glint::grading
