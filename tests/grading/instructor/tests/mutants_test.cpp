// Every known mistake loses points and is named; right answers earn all, skeletons nothing.
#include "tests/grading/cases.hpp"
#include "tests/grading/instructor/variants.hpp"
#include "tests/grading/score.hpp"

#include <doctest/doctest.h>

#include <algorithm>

namespace glint::grading {
namespace {

const Identity somebody{"a secret", "course", "somebody"};

LessonResult graded(const Lesson& lesson, const Variant& v) {
    return score(lesson, [&](int task, const Case&, const Batch& batch) {
        Answered a{Verdict::ok, std::vector<double>(batch.rows() * batch.answers_a_row), "", 0};
        for (std::size_t i = 0; i < batch.rows(); ++i) {
            (batch.number == "double" ? v.as_double : v.as_float)(
                task, &batch.questions[i * batch.columns], &a.answers[i * batch.answers_a_row]);
        }
        return a;
    });
}

const TaskResult& task_of(const LessonResult& r, const std::string& id) {
    return *std::find_if(r.tasks.begin(), r.tasks.end(),
                         [&](const TaskResult& t) { return t.id == id; });
}

// Right tasks of a header in which one is not begun earn all, if that can be told: not where the
// whole skeleton answers the same.
void check_others(const LessonResult& r, const std::string& not_begun) {
    for (const TaskResult& t : r.tasks) {
        const bool told = t.diagnosis != "the skeleton" && !t.diagnosis.starts_with("any answer");
        if (t.id != not_begun) {
            CAPTURE(t.id);
            CHECK(t.earned() == (told ? t.points() : 0));
        }
    }
}

TEST_CASE("right answers earn all points, skeletons none") {
    for (const std::string& name : graded_lessons()) {
        const Lesson lesson = cases_of(name, somebody);
        for (const Variant& v : variants_of(name)) {
            CAPTURE(name);
            const LessonResult r = graded(lesson, v);
            if (v.kind == VariantKind::solution) {
                CHECK(r.verdict == Verdict::ok);
                CHECK(r.earned() == r.points());
            } else if (v.kind == VariantKind::skeleton && *v.task == '\0') {
                CHECK(r.earned() == 0);
            } else if (v.kind == VariantKind::skeleton) {
                CAPTURE(std::string(v.task));
                CHECK(task_of(r, v.task).earned() == 0);
                CHECK(task_of(r, v.task).diagnosis == "the skeleton");
                check_others(r, v.task);
            }
        }
    }
}

TEST_CASE("right answers earn all points whatever is asked and however they are written") {
    for (const std::string& name : graded_lessons()) {
        for (int student = 0; student < 50; ++student) {
            CAPTURE(student);
            const Lesson lesson =
                cases_of(name, Identity{"another secret", "course", std::to_string(student)});
            for (const Variant& v : variants_of(name)) {
                if (v.kind == VariantKind::solution || v.kind == VariantKind::alternative) {
                    CAPTURE(name);
                    CAPTURE(std::string(v.words));
                    const LessonResult r = graded(lesson, v);
                    CHECK(r.earned() == r.points());
                }
            }
        }
    }
}

// These make the same answer of every question that another task is asked, right or not begun.
bool says_all_of_another(const Variant& v) {
    const std::string mutant = std::string(v.task) + ' ' + v.words;
    return mutant == "06.1 the sum over pi" ||
           mutant == "06.1 half of what leaves, as if the azimuth ran over 180 degrees" ||
           mutant == "18.2 c with the wrong sign";
}

TEST_CASE("a property counts no more than the values do, and says so") {
    Lesson lesson = cases_of("09_normalised_phong", somebody);
    const LessonResult r = score(lesson, [&](int task, const Case& asked, const Batch& batch) {
        Answered a{Verdict::ok, std::vector<double>(batch.rows() * batch.answers_a_row), "", 0};
        const auto right = variants_of(lesson.name).front().as_double;
        for (std::size_t i = 0; i < batch.rows() && asked.is_property(); ++i) {
            right(task, &batch.questions[i * batch.columns], &a.answers[i * batch.answers_a_row]);
        }
        return a;
    });
    const TaskResult& lobe = task_of(r, "09.2");
    CHECK(lobe.earned() == 0);
    const auto albedo = std::find_if(lobe.cases.begin(), lobe.cases.end(),
                                     [](const CaseResult& c) { return c.kind == "albedo"; });
    CHECK(albedo->verdict == Verdict::wrong);
    CHECK(albedo->words == "counts no more than the values of its task do");
}

TEST_CASE("every mutant loses points of its task, and only there, and is named") {
    int count = 0;
    int untold = 0;
    for (const std::string& name : graded_lessons()) {
        const Lesson lesson = cases_of(name, somebody);
        for (const Variant& v : variants_of(name)) {
            if (v.kind != VariantKind::mutant) {
                continue;
            }
            CAPTURE(std::string(v.task));
            CAPTURE(std::string(v.words));
            const LessonResult r = graded(lesson, v);
            const TaskResult& task = task_of(r, v.task);
            CHECK(task.earned() < task.points());
            CHECK(task.diagnosis == v.words);
            ++count;
            if (says_all_of_another(v)) {
                const TaskResult& other = task_of(r, task.id == "06.1" ? "06.3" : "18.3");
                CHECK(other.earned() == 0);
                CHECK(other.diagnosis ==
                      "any answer, right or wrong, until " + task.id + " is right");
                ++untold;
            } else {
                CHECK(r.points() - r.earned() == doctest::Approx(task.points() - task.earned()));
            }
        }
    }
    MESSAGE(count, " mutants");
    CHECK(count >= 60);
    CHECK(untold == 3);
}

}  // namespace
}  // namespace glint::grading
