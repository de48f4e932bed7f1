// Grades what one student handed in.
#pragma once

#include "tests/grading/cases.hpp"
#include "tests/grading/report.hpp"

#include <filesystem>

namespace glint::grading {

struct Order {
    std::vector<std::string> lessons;         // names; empty: all that were handed in
    std::string student, assignment, secret;  // no secret: visible cases only
    std::filesystem::path root;               // the tree whose lessons and framework are used
};

// The name of a lesson by its number or name; an Error where it is not graded.
std::string lesson_named(const std::string& word);

// A secret from a file, of 16 bytes at least; an Error where hidden cases must not be run here.
std::string read_secret(const std::filesystem::path& file);

// SHA-256 of what grades: this program and all visible cases.
std::string bundle_hash();

// SHA-256 of the headers that were handed in: nothing else is looked at.
std::string submission_hash(const std::filesystem::path& submission, const Order& order);

// What tells the hidden cases of an order from those of others; empty where it has none.
std::string seed_of(const Order& order);

// An Error where there is no such submission, or a single file of another name than the headers
// that are graded have.
void require_submission(const std::filesystem::path& submission, const Order& order);

// The submission is a header, a folder or a zip archive with some. A header that is ordered and
// missing is skipped.
Report grade_submission(const std::filesystem::path& submission, const Order& order);

// Lessons whose headers this one includes, and theirs, that are graded and not all right by their
// visible cases: in a student's tree these spoil answers that are right.
std::vector<std::string> unsolved_before(const std::string& lesson,
                                         const std::filesystem::path& root);

}  // namespace glint::grading
