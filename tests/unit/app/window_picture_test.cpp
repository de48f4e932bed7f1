#include "framework/app/window_picture.hpp"

#include "framework/app/panels.hpp"
#include "framework/app/window_parcel.hpp"
#include "framework/math/error.hpp"
#include "tests/temporary.hpp"
#include "tests/unit/app/window_lesson.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <fstream>

namespace glint {
namespace {

SrgbImage written(const Lesson& lesson, const Options& o) {
    return draw_panels(lesson, o).srgb;
}

std::vector<Lesson> both_lessons() {
    return {window_lesson(), window_lesson_in_panels()};
}

TEST_CASE("the window shows what the program writes, in every view") {
    for (const Lesson& lesson : both_lessons()) {
        for (int view = 0; view < 6; ++view) {
            Options o = window_options();
            LivePicture live(lesson, o);
            o.view = static_cast<ViewMode>(view);
            live.act(static_cast<Action>(static_cast<int>(Action::view_shaded) + view));
            CAPTURE(view);
            CHECK(live.drawing().srgb == written(lesson, o));
        }
    }
}

TEST_CASE("after a change it shows what the program writes with that option") {
    for (const Lesson& lesson : both_lessons()) {
        Options o = window_options();
        LivePicture live(lesson, o);
        live.drawing();
        const auto check = [&] {
            CHECK(live.stale());
            CHECK(live.drawing().srgb == written(lesson, o));
            CHECK_FALSE(live.stale());
        };
        live.act(Action::next_samples);
        o.settings.samples = 4;
        check();
        live.act(Action::next_rasterizer);
        o.settings.rasterizer = Rasterizer::scanline;
        check();
        live.act(Action::parameter_more);
        o.parameters.set("level", 0.52F);
        check();
        live.act(Action::parameter_next);
        live.act(Action::parameter_more);
        o.parameters.set("day", 1);
        check();
        live.resize(60, 90);
        o.width = 60;
        o.height = 90;
        check();
    }
}

TEST_CASE("it is drawn again only where something changed") {
    const Lesson lesson = window_lesson();
    LivePicture live(lesson, window_options());
    CHECK(live.stale());
    live.drawing();
    live.act(Action::parameter_next);
    live.act(Action::save);
    live.act(Gesture{});
    live.resize(121, 80);
    live.resize(0, 80);
    CHECK_FALSE(live.stale());
    live.redraw();
    CHECK(live.stale());
}

TEST_CASE("the camera goes where hand and keys take it, and back") {
    for (const Lesson& lesson : both_lessons()) {
        LivePicture live(lesson, window_options());
        const SrgbImage before = live.drawing().srgb;
        const auto check_moved_and_reset = [&] {
            CHECK(live.stale());
            CHECK(live.drawing().srgb != before);
            live.act(Action::reset_camera);
            CHECK(live.drawing().srgb == before);
        };
        live.act(Action::orbit_left);
        check_moved_and_reset();
        live.act(Gesture{Gesture::Kind::orbit, 20, 10});
        check_moved_and_reset();
        live.act(Gesture{Gesture::Kind::pan, 5, 0});
        check_moved_and_reset();
        live.zoom_steps(2);
        check_moved_and_reset();
    }
}

TEST_CASE("a drag to the right turns the ball to the right, a wheel forwards brings it nearer") {
    const Lesson lesson = window_lesson();
    LivePicture live(lesson, window_options());
    live.act(Gesture{Gesture::Kind::orbit, 20, 0});
    const SrgbImage turned = live.drawing().srgb;
    CHECK(turned(60, 40).r < turned(60, 40).b);  // the side of -x has come to the front
    const auto covered = [&] {
        return std::ranges::count_if(live.drawing().srgb.pixels(), [](Rgba8 p) { return p.b > 0; });
    };
    live.act(Action::reset_camera);
    const auto before = covered();
    live.zoom_steps(1);
    CHECK(covered() > before);
}

TEST_CASE("the camera stays where it is when a parameter or the size changes") {
    const Lesson lesson = window_lesson_in_panels();
    LivePicture live(lesson, window_options());
    live.act(Action::orbit_left);
    const SrgbImage turned = live.drawing().srgb;
    live.act(Action::parameter_more);
    CHECK(live.drawing().srgb != turned);
    live.act(Action::parameter_less);
    CHECK(live.drawing().srgb == turned);
    live.resize(200, 100);
    live.drawing();
    live.resize(121, 80);
    CHECK(live.drawing().srgb == turned);
}

TEST_CASE("what the user did goes on in another program, with the size, parameters and camera") {
    const Lesson lesson = window_lesson_in_panels();
    LivePicture live(lesson, window_options());
    live.resize(200, 100);
    for (const Action action : {Action::orbit_left, Action::zoom_in, Action::parameter_next,
                                Action::parameter_more, Action::next_samples}) {
        live.act(action);
    }
    live.act(Gesture{Gesture::Kind::click, 30, 50});
    Parcel sent;
    sent.put(live.seen());
    sent.put(live.state());
    Parcel received(sent.bytes());
    Seen seen;
    PictureState state{};
    received.take(seen);
    received.take(state);
    LivePicture other(lesson, window_options());
    CHECK(other.seen().picture != live.seen().picture);
    other.restore(state);
    CHECK(other.seen().picture == live.seen().picture);
    CHECK(seen.picture == live.seen().picture);
    CHECK(other.seen().report == seen.report);
    CHECK(!seen.report.empty());
    CHECK(other.status().back() == seen.status.back());
    CHECK(seen.labels.size() == live.labels().size());
    other.act(Action::reset_camera);
    live.act(Action::reset_camera);
    CHECK(other.seen().picture == live.seen().picture);
    CHECK_THROWS_AS(received.take(seen), Error);
}

TEST_CASE("a click explains the pixel in its panel") {
    const Lesson lesson = window_lesson_in_panels();
    LivePicture live(lesson, window_options());
    CHECK_FALSE(live.report());
    const auto level_at = [&](int x) {
        live.act(Gesture{Gesture::Kind::click, x, 40});
        live.drawing();
        REQUIRE(live.report());
        const auto found = std::ranges::find_if(
            live.report()->readings, [](const Reading& r) { return r.name == "colour.z"; });
        REQUIRE(found != live.report()->readings.end());
        return found->in_double;
    };
    CHECK(level_at(20) == doctest::Approx(0.25).epsilon(0.01));
    CHECK(level_at(60) == doctest::Approx(0.75).epsilon(0.01));
    CHECK(level_at(100) == doctest::Approx(1).epsilon(0.01));
    live.act(Gesture{Gesture::Kind::click, 0, 0});
    live.drawing();
    CHECK(live.report()->readings.empty());
    live.resize(90, 80);
    CHECK(live.options().probe);
    live.act(Gesture{Gesture::Kind::click, 5000, -5000});
    CHECK(live.options().probe == std::pair(89, 0));
    live.resize(50, 80);
    CHECK_FALSE(live.options().probe);
    live.drawing();
    CHECK_FALSE(live.report());
}

TEST_CASE("panels are labelled with what they differ in") {
    const Lesson lesson = window_lesson_in_panels();
    LivePicture live(lesson, window_options());
    const auto labels = live.labels();
    REQUIRE(labels.size() == 3);
    CHECK(labels[0].words == "level = 0.25");
    CHECK(labels[2].words == "level = 1, day = 1");
    CHECK(labels[2].left == 80);
    live.act(Action::parameter_more);
    CHECK(live.labels().empty());
}

TEST_CASE("a mesh file is read once") {
    const TemporaryFolder folder;
    std::ofstream(folder / "one.obj")
        << "v -1 -1 0\nv 1 -1 0\nv 0 1 0\nvn 0 0 1\nf 1//1 2//1 3//1\n";
    Options o = window_options();
    o.scene_file = (folder / "one.obj").string();
    const Lesson lesson = window_lesson();
    LivePicture live(lesson, o);
    o.parameters.set("level", 0.52F);
    const SrgbImage expected = written(lesson, o);
    std::filesystem::remove(folder / "one.obj");
    live.act(Action::parameter_more);
    CHECK(live.drawing().srgb == expected);
    CHECK_THROWS_AS(LivePicture(lesson, o), Error);
}

}  // namespace
}  // namespace glint
