// What grading found: verdicts, points, and the words for them.
#pragma once

#include "framework/image/image.hpp"

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace glint::grading {

enum class Verdict {
    ok,
    wrong,
    timeout,
    memory,
    output_limit,
    crash,
    forbidden,
    protocol,
    compile_error,
    compile_limit,
    link_error,
    rejected,
    skipped,
    internal_error,  // the grader's own; never a zero: to be graded again
};

constexpr std::string_view name_of(Verdict v) {
    constexpr std::array<std::string_view, 14> names{
        "ok",         "wrong",     "timeout",  "memory",        "output limit",
        "crash",      "forbidden", "protocol", "compile error", "compile limit",
        "link error", "rejected",  "skipped",  "internal error"};
    return names[static_cast<std::size_t>(v)];
}

// The first check that failed: of a value, or of a sum for a property.
struct Failure {
    std::string number;
    std::string of;                // what the question's numbers are: see Task
    std::vector<double> question;  // the row of the check's first answer
    std::size_t component;         // which of the row's answers
    double low, high, got;
    std::string place;  // in the picture; else empty
};

// What answers look like, for people.
struct Shown {
    SrgbImage picture;   // as it is to be, as it is, and how far they differ; empty for a raster
    std::string raster;  // coverage: # right, ! too much, ? missing, . nothing
};

struct CaseResult {
    std::string name, kind;
    bool hidden;
    double points, earned;
    Verdict verdict;
    std::string words;  // what went wrong, for people; of hidden cases for instructors alone
    std::optional<Failure> failure;
    double seconds;              // of the slowest run
    std::optional<Shown> shown;  // never of hidden cases
};

struct TaskResult {
    std::string id, title;
    std::string diagnosis;  // the known mistake that the answers look like; else empty
    std::vector<CaseResult> cases;

    double points() const;
    double earned() const;
};

struct LessonResult {
    std::string lesson;
    Verdict verdict;    // of all: ok only if every case is
    std::string words;  // why nothing was run; the compiler's words
    std::vector<TaskResult> tasks;

    double points() const;
    double earned() const;
};

}  // namespace glint::grading
