// What all forms of a report say about a case and a lesson.
#pragma once

#include "tests/grading/report.hpp"

namespace glint::grading {

// Calls f(lesson, task, case) for every case.
template <class F>
void for_each_case(const Report& report, F f) {
    for (const LessonResult& lesson : report.lessons) {
        for (const TaskResult& task : lesson.tasks) {
            for (const CaseResult& c : task.cases) {
                f(lesson, task, c);
            }
        }
    }
}

// What was wrong with a case, as a student may know it: what kept the lesson from being run, a
// known mistake, the first value that is wrong.
inline std::string words_for(const LessonResult& lesson, const TaskResult& task,
                             const CaseResult& c) {
    if (!lesson.words.empty()) {
        return std::string(name_of(lesson.verdict)) + ": " + lesson.words;
    }
    const std::string words = explain(c);
    return words.empty() || task.diagnosis.empty()
               ? words
               : "Your values are those of " + task.diagnosis + ".\n" + words;
}

}  // namespace glint::grading
