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

TEST_CASE("every mutant loses points of its task, and only there, and is named") {
    int count = 0;
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
            CHECK(r.points() - r.earned() == doctest::Approx(task.points() - task.earned()));
            ++count;
        }
    }
    MESSAGE(count, " mutants");
    CHECK(count >= 60);
}

}  // namespace
}  // namespace glint::grading
