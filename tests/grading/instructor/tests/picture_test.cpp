// What students see of their answers: pictures of the lessons, rasters of a triangle.
#include "tests/grading/picture.hpp"

#include "tests/grading/cases.hpp"
#include "tests/grading/instructor/variants.hpp"
#include "tests/grading/score.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <map>

namespace glint::grading {
namespace {

// Answers of the solution, and how each is changed.
LessonResult graded(const Lesson& lesson, double (*change)(double)) {
    return score(lesson, [&](int task, const Case&, const Batch& batch) {
        Answered a{Verdict::ok, std::vector<double>(batch.rows() * batch.answers_a_row), "", 0};
        for (std::size_t i = 0; i < batch.rows(); ++i) {
            variants_of(lesson.name)[0].as_double(task, &batch.questions[i * batch.columns],
                                                  &a.answers[i * batch.answers_a_row]);
        }
        std::transform(a.answers.begin(), a.answers.end(), a.answers.begin(), change);
        return a;
    });
}

std::vector<CaseResult> shown_cases(const LessonResult& r, const std::string& kind) {
    std::vector<CaseResult> all;
    for (const TaskResult& t : r.tasks) {
        std::copy_if(t.cases.begin(), t.cases.end(), std::back_inserter(all),
                     [&](const CaseResult& c) { return c.kind == kind; });
    }
    return all;
}

// Pixels of the part 0, 1 or 2 of a picture that are not black.
int lit_pixels(const SrgbImage& picture, int part) {
    const int side = picture.height();  // parts are square, lines between them
    int count = 0;
    for (int y = 0; y < side; ++y) {
        for (int x = 0; x < side; ++x) {
            const Rgba8 p = picture(part * (picture.width() - side) / 2 + x, y);
            count += p.r + p.g + p.b > 30 ? 1 : 0;
        }
    }
    return count;
}

TEST_CASE("the lessons that draw have pictures that show what they are about") {
    for (const char* name : {"01_ad_hoc_phong", "08_normalised_lambert", "09_normalised_phong",
                             "13_specular_colour", "15_engine_integration"}) {
        CAPTURE(std::string(name));
        const Lesson lesson = cases_of(name, std::nullopt);
        const auto right = shown_cases(graded(lesson, [](double x) { return x; }), "picture");
        const auto black = shown_cases(graded(lesson, [](double) { return 0.0; }), "picture");
        REQUIRE(!right.empty());
        for (std::size_t i = 0; i < right.size(); ++i) {
            CHECK(right[i].earned == right[i].points);
            REQUIRE(right[i].shown);
            const SrgbImage& picture = right[i].shown->picture;
            CHECK(lit_pixels(picture, 0) > 100);
            CHECK(lit_pixels(picture, 0) == lit_pixels(picture, 1));
            CHECK(black[i].earned == 0);
            CHECK(lit_pixels(black[i].shown->picture, 1) == 0);
            REQUIRE(black[i].failure);
            CHECK(black[i].failure->got == 0);
            CHECK(black[i].failure->place.starts_with("pixel "));
        }
    }
}

TEST_CASE("a NaN is the worst pixel, and is black") {
    const Lesson lesson = cases_of("08_normalised_lambert", std::nullopt);
    const auto cases = shown_cases(graded(lesson, [](double) { return std::nan(""); }), "picture");
    CHECK(cases.at(0).earned == 0);
    CHECK(std::isnan(cases.at(0).failure->got));
    CHECK(lit_pixels(cases.at(0).shown->picture, 1) == 0);
}

TEST_CASE("rasters tell too much from missing") {
    const Lesson lesson = cases_of("18_scanline_to_tiles", std::nullopt);
    const auto count = [&](double (*change)(double)) {
        std::map<char, int> signs;
        for (const CaseResult& c : shown_cases(graded(lesson, change), "coverage")) {
            for (const char sign : c.shown->raster) {
                ++signs[sign];
            }
        }
        return signs;
    };
    auto right = count([](double x) { return x; });
    CHECK(right['#'] > 100);
    CHECK(right['!'] + right['?'] == 0);
    auto all = count([](double) { return 1.0; });
    CHECK(all['#'] == right['#']);
    CHECK(all['!'] == right['.']);
    auto none = count([](double) { return 0.0; });
    CHECK(none['?'] == right['#']);
    CHECK(none['.'] == right['.']);
    CHECK(none['\n'] == 13 + 12);
}

}  // namespace
}  // namespace glint::grading
