#include "tests/grading/exports/exports.hpp"
#include "tests/grading/exports/pictures.hpp"
#include "tests/grading/exports/words.hpp"

#include <nlohmann/json.hpp>

namespace glint::grading {

using nlohmann::ordered_json;

static std::string words_and_raster(const LessonResult& l, const TaskResult& t,
                                    const CaseResult& c) {
    const std::string raster = raster_of(c);
    return words_for(l, t, c) + (raster.empty() ? "" : '\n' + raster);
}

// Gradescope shows pictures in HTML alone; where it takes them out, their words stay.
static std::string as_markup(const std::string& words, const CaseResult& c) {
    return "<pre>" + escaped(words) + "</pre><img alt=\"" + picture_parts + "\" src=\"" +
           picture_url(c) + "\" style=\"width:100%;image-rendering:pixelated\">";
}

// https://gradescope-autograders.readthedocs.io/en/latest/specs/: a single hidden test would hide
// the total, so hidden cases are visible tests that say nothing.
std::string as_gradescope(const Report& report) {
    ordered_json j{{"score", report.earned()},
                   {"output_format", "text"},
                   {"stdout_visibility", "hidden"},
                   {"tests", ordered_json::array()}};
    for_each_case(report, [&](const LessonResult& l, const TaskResult& t, const CaseResult& c) {
        const std::string words = words_and_raster(l, t, c);
        const bool drawn = has_picture(c) && c.verdict != Verdict::ok;
        j["tests"].push_back({{"name", t.title + ": " + c.name},
                              {"number", t.id},
                              {"score", c.earned},
                              {"max_score", c.points},
                              {"status", c.verdict == Verdict::ok ? "passed" : "failed"},
                              {"output", drawn ? as_markup(words, c) : words},
                              {"output_format", drawn ? "html" : "text"},
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
                              {"output", words_and_raster(l, t, c)}});
        if (has_picture(c)) {
            j["tests"].back()["images"] = {{{"label", picture_parts}, {"url", picture_url(c)}}};
        }
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
