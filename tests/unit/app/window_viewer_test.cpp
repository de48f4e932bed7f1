#include "framework/app/window_viewer.hpp"

#include "framework/app/window_compare.hpp"
#include "framework/image/png.hpp"
#include "framework/math/error.hpp"
#include "tests/temporary.hpp"
#include "tests/unit/app/window_lesson.hpp"

#include <doctest/doctest.h>

namespace glint {
namespace {

constexpr Rgba8 white{255, 255, 255, 255};

class Shown {
  public:
    explicit Shown(const Options& options = window_options()) : viewer(lesson_, options) {}

  private:
    Lesson lesson_ = window_lesson();

  public:
    Viewer viewer;
};

TEST_CASE("without words the window shows the picture alone") {
    Shown shown;
    Viewer& v = shown.viewer;
    CHECK(v.stale());
    CHECK(v.frame() != v.picture());
    CHECK_FALSE(v.stale());
    v.act(Action::show_words);
    CHECK(v.stale());
    CHECK(v.frame() == v.picture());
    v.act(Action::show_keys);
    CHECK(v.frame() != v.picture());
    v.act(Action::dismiss);
    CHECK(v.frame() == v.picture());
}

TEST_CASE("what changes nothing asks for no drawing") {
    Shown shown;
    Viewer& v = shown.viewer;
    v.frame();
    v.act(Gesture{});
    v.resize(121, 80);
    CHECK_FALSE(v.stale());
    v.act(Gesture{Gesture::Kind::orbit, 9, 0});
    CHECK(v.stale());
    v.frame();
    v.zoom_steps(1);
    CHECK(v.stale());
    v.frame();
    v.redraw();
    CHECK(v.stale());
    v.picture();
    CHECK(v.stale());
}

TEST_CASE("a kept picture is left of the split line, the new one right of it") {
    Shown shown;
    Viewer& v = shown.viewer;
    v.act(Action::show_words);
    const SrgbImage kept = v.picture();
    v.act(Action::keep_picture);
    v.act(Action::parameter_more);
    CHECK(v.picture() != kept);
    CHECK(v.frame() == split_picture(kept, v.picture(), 60));
    CHECK(v.on_split_line(60));
    CHECK(v.on_split_line(55));
    CHECK_FALSE(v.on_split_line(50));
    for (const int x : {0, 30, 120}) {
        v.act(Gesture{Gesture::Kind::split, x, 7});
        CHECK(v.stale());
        CHECK(v.frame() == split_picture(kept, v.picture(), x));
        CHECK(v.on_split_line(x));
    }
    v.act(Gesture{Gesture::Kind::split, 5000, 7});
    CHECK(v.frame()(120, 3) == white);
    v.act(Action::show_split);
    CHECK(v.frame() == v.picture());
    CHECK_FALSE(v.on_split_line(120));
}

TEST_CASE("the difference view shows how far the picture is from the kept one") {
    Shown shown;
    Viewer& v = shown.viewer;
    v.act(Action::show_words);
    const SrgbImage kept = v.picture();
    v.act(Action::keep_picture);
    v.act(Action::next_samples);
    v.act(Action::show_difference);
    const SrgbImage expected = code_difference(kept, v.picture()).picture;
    const SrgbImage& frame = v.frame();
    int same = 0;
    for (int y = 0; y < 30; ++y) {  // the legend lies below
        for (int x = 0; x < 121; ++x) {
            same += frame(x, y) == expected(x, y) ? 1 : 0;
        }
    }
    CHECK(same == 30 * 121);
    v.act(Action::show_difference);
    CHECK(v.frame() == v.picture());
}

TEST_CASE("without a kept picture there is nothing to compare with") {
    Shown shown;
    Viewer& v = shown.viewer;
    const SrgbImage before = v.frame();
    v.act(Action::show_split);
    CHECK(v.frame() != before);  // says so
    v.act(Action::show_words);
    v.act(Action::show_difference);
    CHECK(v.frame() == v.picture());
}

TEST_CASE("pictures of two sizes are not compared") {
    Shown shown;
    Viewer& v = shown.viewer;
    v.act(Action::keep_picture);
    v.resize(130, 80);
    v.act(Action::show_words);
    CHECK(v.frame() == v.picture());
    CHECK(v.picture().width() == 130);
    v.resize(121, 80);
    CHECK(v.frame() != v.picture());
}

TEST_CASE("it starts by comparing with the picture that the options name") {
    const TemporaryFolder folder;
    const SrgbImage reference(121, 80, Rgba8{1, 2, 3, 255});
    write_png(folder / "reference.png", reference);
    Options o = window_options();
    o.compare = (folder / "reference.png").string();
    Shown shown(o);
    shown.viewer.act(Action::show_words);
    CHECK(shown.viewer.frame() == split_picture(reference, shown.viewer.picture(), 60));
    o.width = 120;
    CHECK_THROWS_AS(Shown{o}, Error);
    o.compare = (folder / "missing.png").string();
    CHECK_THROWS_AS(Shown{o}, Error);
}

TEST_CASE("a click explains its pixel until it is dismissed") {
    Options o = window_options();
    o.width = 900;
    o.height = 500;
    Shown shown(o);
    Viewer& v = shown.viewer;
    v.act(Action::show_words);
    const auto differs_at = [&](int left, int right) {
        int pixels = 0;
        for (int y = 0; y < 500; ++y) {
            for (int x = left; x < right; ++x) {
                pixels += v.frame()(x, y) == v.picture()(x, y) ? 0 : 1;
            }
        }
        return pixels;
    };
    v.act(Gesture{Gesture::Kind::click, 300, 250});
    CHECK(v.stale());
    CHECK(v.frame()(306, 250) == white);  // its mark
    CHECK(v.frame()(300, 250) == v.picture()(300, 250));
    CHECK(differs_at(500, 900) > 5000);
    v.act(Gesture{Gesture::Kind::click, 850, 250});
    CHECK(differs_at(0, 400) > 5000);
    CHECK(v.frame()(856, 250) == white);
    v.act(Action::dismiss);
    CHECK(differs_at(0, 900) == 0);
    CHECK_FALSE(v.options().probe);
}

TEST_CASE("saving writes the picture alone, under a name that is free") {
    const TemporaryFolder folder;
    Options o = window_options();
    o.outs = {(folder / "new").string() + "/ball.png", "other.pfm"};
    Shown shown(o);
    Viewer& v = shown.viewer;
    v.act(Action::keep_picture);
    v.act(Action::orbit_left);
    v.act(Action::save);
    v.act(Action::save);
    CHECK(read_png(folder / "new/ball-shot.png") == v.picture());
    CHECK(read_png(folder / "new/ball-shot2.png") == v.picture());
}

TEST_CASE("a picture that cannot be saved does not end the window") {
    Options o = window_options();
    o.outs = {"/dev/null/ball.png"};
    Shown shown(o);
    const SrgbImage before = shown.viewer.frame();
    CHECK_NOTHROW(shown.viewer.act(Action::save));
    CHECK(shown.viewer.frame() != before);  // says so
    CHECK_FALSE(shown.viewer.closed());
}

TEST_CASE("it closes when it is told to") {
    Shown shown;
    CHECK_FALSE(shown.viewer.closed());
    shown.viewer.act(Action::close);
    CHECK(shown.viewer.closed());
}

}  // namespace
}  // namespace glint
