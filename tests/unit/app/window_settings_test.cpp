#include "framework/app/window_settings.hpp"

#include "framework/math/dispatch.hpp"

#include <doctest/doctest.h>

#include <set>

namespace glint {
namespace {

TEST_CASE("lanes go round through all that the build has") {
    Options o;
    o.settings.lanes = 1;
    std::set<int> seen;
    do {
        CHECK(has_lanes(o.settings.lanes));
        seen.insert(o.settings.lanes);
        CHECK(change_settings(o, Action::next_lanes));
    } while (o.settings.lanes != 1 && seen.size() < 9);
    CHECK(seen.contains(4));
    CHECK(seen.contains(max_lanes));
}

TEST_CASE("samples go round through 1, 2, 4, 8, 16") {
    Options o;
    o.settings.samples = 1;
    for (const int expected : {2, 4, 8, 16, 1}) {
        CHECK(change_settings(o, Action::next_samples));
        CHECK(o.settings.samples == expected);
    }
}

TEST_CASE("rasterizer and culling switch to and fro") {
    Options o;
    CHECK(change_settings(o, Action::next_rasterizer));
    CHECK(o.settings.rasterizer == Rasterizer::scanline);
    CHECK(change_settings(o, Action::next_rasterizer));
    CHECK(o.settings.rasterizer == Rasterizer::tiles);
    CHECK(change_settings(o, Action::next_culling));
    CHECK(o.settings.cull == Cull::back);
    CHECK(change_settings(o, Action::next_culling));
    CHECK(o.settings.cull == Cull::none);
}

TEST_CASE("each view has its action, others change nothing") {
    Options o;
    constexpr int first = static_cast<int>(Action::view_shaded);
    for (int i = 5; i >= 0; --i) {
        CHECK(change_settings(o, static_cast<Action>(first + i)));
        CHECK(static_cast<int>(o.view) == i);
    }
    for (const Action action : {Action::orbit_left, Action::parameter_more, Action::save}) {
        CHECK_FALSE(change_settings(o, action));
    }
}

TEST_CASE("parameters are chosen in a ring and move within their limits") {
    Parameters p{{"exponent", 50, 0, 100, "n"}, {"count", 1, 0, 2, "how many", true}};
    std::size_t chosen = 0;
    CHECK(change_parameters(p, chosen, Action::parameter_more));
    CHECK(p["exponent"] == 52);
    CHECK(change_parameters(p, chosen, Action::parameter_less));
    CHECK(p["exponent"] == 50);
    CHECK_FALSE(change_parameters(p, chosen, Action::parameter_previous));
    CHECK(chosen == 1);
    CHECK(change_parameters(p, chosen, Action::parameter_more));
    CHECK(p["count"] == 2);
    CHECK_FALSE(change_parameters(p, chosen, Action::parameter_more));
    CHECK(p["count"] == 2);
    CHECK_FALSE(change_parameters(p, chosen, Action::parameter_next));
    CHECK(chosen == 0);
    for (int i = 0; i < 60; ++i) {
        change_parameters(p, chosen, Action::parameter_less);
    }
    CHECK(p["exponent"] == 0);
    CHECK_FALSE(change_parameters(p, chosen, Action::save));
}

TEST_CASE("there and back again is the same number") {
    Parameters p{{"index", 1.5F, 0.1F, 10, "n"}, {"part", 0.3F, 0, 1, "of all"}};
    for (std::size_t chosen : {0U, 1U}) {
        const float before = p.all()[chosen].value;
        for (const Action there : {Action::parameter_less, Action::parameter_more}) {
            const bool less = there == Action::parameter_less;
            for (int i = 0; i < 5; ++i) {
                CHECK(change_parameters(p, chosen, there));
            }
            CHECK((p.all()[chosen].value < before) == less);
            for (int i = 0; i < 5; ++i) {
                change_parameters(p, chosen,
                                  less ? Action::parameter_more : Action::parameter_less);
            }
            CHECK(p.all()[chosen].value == before);
        }
    }
}

TEST_CASE("a lesson may have no parameters") {
    Parameters none;
    std::size_t chosen = 0;
    CHECK_FALSE(change_parameters(none, chosen, Action::parameter_next));
    CHECK_FALSE(change_parameters(none, chosen, Action::parameter_more));
    CHECK(chosen == 0);
}

}  // namespace
}  // namespace glint
