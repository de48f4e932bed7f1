#include "framework/app/window_overlay.hpp"

#include <doctest/doctest.h>

#include <algorithm>

namespace glint {
namespace {

constexpr Rgba8 grey{128, 128, 128, 255};

TEST_CASE("a panel covers its rectangle and nothing else") {
    SrgbImage image(200, 100, grey);
    const WordsPanel panel{{"one", "another"}, 1.5F};
    panel.draw(image, 10, 20);
    for (int y = 0; y < image.height(); ++y) {
        for (int x = 0; x < image.width(); ++x) {
            const bool inside =
                x >= 10 && x < 10 + panel.width() && y >= 20 && y < 20 + panel.height();
            CHECK((image(x, y) != grey) == inside);
        }
    }
    const auto bright = std::ranges::count_if(image.pixels(), [](Rgba8 p) { return p.g > 220; });
    CHECK(bright > 50);
}

TEST_CASE("a panel grows with its longest line, its lines and its letters") {
    const WordsPanel small{{"abc"}, 1};
    CHECK(WordsPanel{{"abcd"}, 1}.width() > small.width());
    CHECK(WordsPanel{{"abc", ""}, 1}.height() > small.height());
    CHECK(WordsPanel{{"abc"}, 2}.width() > small.width());
}

TEST_CASE("a panel that is too high is written smaller, then cut short") {
    const Lines lines(20, "line");
    const int high = WordsPanel{lines, 1.5F}.height();
    CHECK(fitting_panel(lines, 1.5F, high).scale == 1.5F);
    const WordsPanel smaller = fitting_panel(lines, 1.5F, high - 1);
    CHECK(smaller.scale == 1);
    CHECK(smaller.lines.size() == 20);
    const WordsPanel cut = fitting_panel(lines, 1.5F, smaller.height() - 1);
    CHECK(cut.lines.size() == 19);
    CHECK(cut.lines.back() == "... 2 more lines: enlarge the window");
    CHECK(cut.height() < smaller.height());
    CHECK(fitting_panel(lines, 1, 0).lines.size() == 1);
}

TEST_CASE("higher windows have larger letters") {
    CHECK(words_scale(300) == 1);
    CHECK(words_scale(540) > words_scale(300));
    CHECK(words_scale(2160) > words_scale(1080));
}

TEST_CASE("a mark surrounds its pixel and leaves it free") {
    SrgbImage image(41, 41, grey);
    draw_mark(image, 20, 20);
    CHECK(image(20, 20) == grey);
    for (const int way : {-1, 1}) {
        CHECK(image(20 + 6 * way, 20) == Rgba8{255, 255, 255, 255});
        CHECK(image(20, 20 + 6 * way) == Rgba8{255, 255, 255, 255});
        CHECK(image(20 + 6 * way, 21) == Rgba8{0, 0, 0, 255});
    }
    SrgbImage corner(5, 5, grey);
    draw_mark(corner, 0, 4);
    CHECK(corner(0, 4) == grey);
}

TEST_CASE("the legend lies in the lower right corner and may not fit") {
    SrgbImage image(400, 200, grey);
    draw_difference_legend(image, 1.5F);
    CHECK(image(10, 10) == grey);
    CHECK(image(100, 190) == grey);
    CHECK(image(380, 190) != grey);
    SrgbImage tiny(20, 10, grey);
    CHECK_NOTHROW(draw_difference_legend(tiny, 1.5F));
}

}  // namespace
}  // namespace glint
