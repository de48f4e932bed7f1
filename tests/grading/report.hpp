// What grading found, told: as JSON for programs, on one screen for the student.
#pragma once

#include "tests/grading/result.hpp"

#include <nlohmann/json_fwd.hpp>

#include <iosfwd>

namespace glint::grading {

struct Report {
    std::string student, assignment;
    std::string submission, bundle;  // SHA-256 of what was handed in, and of what graded it
    std::string seed;                // of the hidden cases; empty where there were none
    std::vector<LessonResult> lessons;

    double points() const;
    double earned() const;
    bool is_final() const;  // nothing went wrong on the grader's side
};

inline constexpr int report_schema = 1;

// All there is, hidden cases too: for instructors.
nlohmann::json to_json(const Report& report);

// For the student: what was wrong first, what it looks like, where to read. Of hidden cases
// nothing but the points.
void print(std::ostream& out, const Report& report);

// What a student may know of a case that was not passed; empty for one that was.
std::string explain(const CaseResult& c);

// "1.25": at most two digits, no more than needed.
std::string points_text(double points);

}  // namespace glint::grading
