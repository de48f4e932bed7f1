#include "tests/grading/exports/exports.hpp"
#include "tests/grading/exports/words.hpp"

#include <nlohmann/json.hpp>

namespace glint::grading {

using nlohmann::ordered_json;

// https://gradescope-autograders.readthedocs.io/en/latest/specs/: a single hidden test would hide
// the total, so hidden cases are visible tests that say nothing.
std::string as_gradescope(const Report& report) {
    ordered_json j{{"score", report.earned()},
                   {"output_format", "text"},
                   {"stdout_visibility", "hidden"},
                   {"tests", ordered_json::array()}};
    for_each_case(report, [&](const LessonResult& l, const TaskResult& t, const CaseResult& c) {
        j["tests"].push_back({{"name", t.title + ": " + c.name},
                              {"number", t.id},
                              {"score", c.earned},
                              {"max_score", c.points},
                              {"status", c.verdict == Verdict::ok ? "passed" : "failed"},
                              {"output", words_for(l, t, c)},
                              {"output_format", "text"},
                              {"visibility", "visible"}});
    });
    if (!report.is_final()) {
        j["output"] = "The grader itself failed; this is no grade. Tell your instructor.";
    }
    return j.dump(1) + '\n';
}

// PrairieLearn, docs/externalGrading.md. What is not final is not gradable.
std::string as_prairielearn(const Report& report) {
    ordered_json j{{"gradable", report.is_final()},
                   {"score", report.points() > 0 ? report.earned() / report.points() : 0},
                   {"tests", ordered_json::array()}};
    for_each_case(report, [&](const LessonResult& l, const TaskResult& t, const CaseResult& c) {
        j["tests"].push_back({{"name", t.id + " " + c.name},
                              {"description", t.title},
                              {"points", c.earned},
                              {"max_points", c.points},
                              {"output", words_for(l, t, c)}});
    });
    return j.dump(1) + '\n';
}

// Autolab, docs/lab.md: one line, the problems being the tasks.
std::string as_autolab(const Report& report) {
    ordered_json scores = ordered_json::object();
    for (const LessonResult& lesson : report.lessons) {
        for (const TaskResult& task : lesson.tasks) {
            scores[task.id] = task.earned();
        }
    }
    return ordered_json{{"scores", scores}}.dump() + '\n';
}

}  // namespace glint::grading
