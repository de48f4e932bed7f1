// From answers to points. Where answers come from is the caller's matter.
#pragma once

#include "tests/grading/case.hpp"
#include "tests/grading/result.hpp"

#include <functional>

namespace glint::grading {

struct Answered {
    Verdict verdict;              // ok: there are answers, right or wrong
    std::vector<double> answers;  // as many as the batch asks for
    std::string words;            // what went wrong
    double seconds;
};

// Answers the questions of one batch for the task of that number: 2 for 09.2.
using Answerer = std::function<Answered(int task, const Case& asked, const Batch& batch)>;

// A task whose answers are right but for a known mistake in another task of the same header, or
// because that is not begun, earns what it would without: each mistake is paid for once. But not
// where that mistake makes the same answer of every question: then nothing tells that the task's
// own answer is right. A property earns no greater a share than
// the task's values do, as far as they are visible or hidden as it is: black conserves energy.
LessonResult score(const Lesson& lesson, const Answerer& answerer);

// The same result for a lesson of which nothing could be run.
LessonResult not_run(const Lesson& lesson, Verdict verdict, const std::string& words);

}  // namespace glint::grading
