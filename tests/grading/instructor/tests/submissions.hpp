// Submissions with the verdicts that they are to get: a right answer to lesson 12 with something
// put before it, or with another answer to 12.1.
#pragma once

#include "tests/grading/grade_lesson.hpp"

#include <string>
#include <vector>

namespace glint::grading {

struct Submission {
    std::string verdict, words;
    std::string text;  // of the whole header
};

// A file of submissions/ has, as often as one likes,
//
//     // SUBMISSION forbidden opens a file
//     lines at the start of the header
//     // ANSWER
//     lines for the answer to 12.1
//
// where the last three may be missing.
std::vector<Submission> read_submissions(const std::string& file);

// Task 12.1, with hidden cases.
Lesson lesson_of_submissions();

LessonResult graded(const Submission& submission);

}  // namespace glint::grading
