#include "framework/app/plan.hpp"

#include "framework/app/picture.hpp"
#include "framework/image/srgb.hpp"
#include "tests/unit/app/small_lesson.hpp"

#include <doctest/doctest.h>

namespace glint {
namespace {

// A colour of code 100 and a planted error; the work is done before the error is added.
struct Planted {
    float error;  // codes
    int work;     // roots a fragment
    template <class T>
    struct Varyings {
        T one;
    };
    static Varyings<float> vertex(const Vertex&) { return {1.0F}; }
    template <Real T>
    Rgb<T> operator()(const Varyings<T>& in) const {
        T x = in.one;
        for (int i = 0; i < work; ++i) {
            x = sqrt(x + T(static_cast<float>(i % 2)));
        }
        const double radiance = srgb_decode((100 + double{error}) / 255);
        return Rgb<T>(T(radiance) + T(1e-12F) * x);
    }
};

// Forms of 0, 0.5 and 3 codes of error; their work, and what a second parameter adds to the error.
Lesson planted(std::array<int, 3> work, float more = 0) {
    Lesson lesson = small_lesson();
    lesson.parameters = {{"form", 0, 0, 2, "", true, {"exact", "near", "rough"}},
                         {"second", 0, 0, 1, "", true, {"dear", "cheap"}}};
    lesson.shaders = shade_each_material([=](const Scene&, const Material&, const Parameters& p) {
        constexpr float errors[] = {0, 0.5F, 3};
        const auto form = static_cast<std::size_t>(p["form"]);
        const bool cheap = p["second"] > 0;
        return Planted{errors[form] + (cheap ? more : 0.0F), cheap ? work[form] / 2 : work[form]};
    });
    return lesson;
}

Plan plan_of(const Lesson& lesson, float tolerance, std::vector<std::string> set = {"second"}) {
    Options o = small_options();
    o.parameters = lesson.parameters;
    o.set = std::move(set);
    o.tolerance = tolerance;
    return make_plan(lesson, o, ball_before_wall());
}

TEST_CASE("a plan takes the cheapest form within the tolerance") {
    const Lesson lesson = planted({4000, 1000, 100});
    const struct {
        float tolerance, form;
        double error;
    } cases[] = {{4, 2, 3}, {1, 1, 0.5}, {0.25, 0, 0}};
    for (const auto& c : cases) {
        CAPTURE(c.tolerance);
        const Plan plan = plan_of(lesson, c.tolerance);
        CHECK(plan.met());
        CHECK(plan.chosen.parameters["form"] == c.form);
        CHECK(plan.chosen.error == doctest::Approx(c.error).epsilon(0.01));
        CHECK(plan.full.error < 0.01);
        CHECK(plan.savings.size() == (c.form > 0 ? 1 : 0));
        CHECK(plan.chosen.ms <= plan.full.ms);
    }
    const Plan plan = plan_of(lesson, 4);
    CHECK(plan.savings[0].full == "exact");
    CHECK(plan.savings[0].cheaper == "rough");
    CHECK(plan.savings[0].without.ms > plan.chosen.ms);
    CHECK(plan_table(plan).find("rough; with exact: +") != std::string::npos);
}

TEST_CASE("errors of several forms are measured together") {
    const Lesson lesson = planted({4000, 1000, 100}, 0.4F);
    CHECK(plan_of(lesson, 0.95F, {}).chosen.parameters["second"] == 1);  // 0.5 + 0.4
    const Plan tight = plan_of(lesson, 0.7F, {});                        // 0.5 or 0.4, not both
    CHECK(tight.chosen.parameters["form"] == 1);
    CHECK(tight.chosen.parameters["second"] == 0);
    CHECK(tight.met());
}

TEST_CASE("a form that saves no time is not taken") {
    const Plan plan = plan_of(planted({1000, 4000, 4000}), 4);
    CHECK(plan.chosen.parameters["form"] == 0);
    CHECK(plan.savings.empty());
}

TEST_CASE("what the command line sets stays") {
    Lesson lesson = planted({4000, 1000, 100});
    lesson.parameters.set("form", 1);
    const Plan plan = plan_of(lesson, 4, {"form", "second"});
    CHECK(plan.chosen.parameters["form"] == 1);
    CHECK(plan.savings.empty());
}

TEST_CASE("where nothing is within the tolerance, the full model is drawn and it is said") {
    Lesson lesson = planted({4000, 1000, 100});
    lesson.shaders = small_lesson().shaders;
    const Plan plan = plan_of(lesson, 1e-9F);
    CHECK_FALSE(plan.met());
    CHECK(plan.chosen.parameters["form"] == 0);
    CHECK(plan_table(plan).find("nothing meets it") != std::string::npos);
}

TEST_CASE("a form that is not a number is not within any tolerance") {
    Lesson lesson = planted({4000, 1000, 100});
    lesson.shaders = shade_each_material([](const Scene&, const Material&, const Parameters& p) {
        return Planted{p["form"] == 0 ? 0.0F : std::numeric_limits<float>::quiet_NaN(),
                       p["form"] == 0 ? 4000 : 100};
    });
    CHECK(plan_of(lesson, 255).chosen.parameters["form"] == 0);
}

TEST_CASE("samples are shaded once a triangle where that is near enough") {
    const Lesson lesson = planted({2000, 1000, 100});
    Options o = small_options();
    o.parameters = lesson.parameters;
    o.set = {"form", "second"};
    o.settings.samples = 4;
    o.settings.sample_shading = true;
    o.tolerance = 1;
    const Plan plan = make_plan(lesson, o, ball_before_wall());
    CHECK_FALSE(plan.chosen.sample_shading);
    CHECK_FALSE(planned(plan, o).settings.sample_shading);
    CHECK(planned(plan, o).tolerance == 0);
}

TEST_CASE("a drawing with a tolerance is that of its plan") {
    const Lesson lesson = planted({4000, 1000, 100});
    Options o = small_options();
    o.parameters = lesson.parameters;
    o.tolerance = 1;
    const Drawing drawing = draw(lesson, o, ball_before_wall());
    REQUIRE(drawing.plans.size() == 1);
    o.tolerance = 0;
    o.parameters = drawing.plans[0].chosen.parameters;
    CHECK(o.parameters["form"] == 1);
    CHECK(draw(lesson, o, ball_before_wall()).srgb == drawing.srgb);
}

}  // namespace
}  // namespace glint
