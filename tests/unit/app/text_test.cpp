#include "framework/app/text.hpp"

#include <doctest/doctest.h>

#include <set>
#include <vector>

namespace glint {
namespace {

constexpr Rgba8 black{0, 0, 0, 255};
constexpr Rgba8 white{255, 255, 255, 255};

SrgbImage written(std::string_view text, float scale = 1, int x = 0, int y = 0) {
    SrgbImage image(80, 40, black);
    draw_text(image, x, y, text, scale, white);
    return image;
}

TEST_CASE("letters differ, and keep to their cells") {
    std::set<std::vector<bool>> shapes;
    for (char letter = ' '; letter <= '~'; ++letter) {
        const SrgbImage image = written({&letter, 1}, 1, cell_width, 0);
        std::vector<bool> shape;
        for (int y = 0; y < image.height(); ++y) {
            for (int x = 0; x < image.width(); ++x) {
                const bool ink = image(x, y) != black;
                shape.push_back(ink);
                CAPTURE(letter);
                // W, m and their like take a pixel more than their cell.
                CHECK_FALSE((ink && (x < cell_width - 1 || x > 2 * cell_width + 1)));
                CHECK_FALSE((ink && y > cell_height));
            }
        }
        shapes.insert(shape);
    }
    CHECK(shapes.size() == 94);  // l and the bar look alike
}

TEST_CASE("a letter's place depends on its number alone") {
    const SrgbImage one = written("i.W");
    const SrgbImage other = written("WmW");
    for (int y = 0; y < cell_height; ++y) {
        for (int x = 2 * cell_width + 1; x < one.width(); ++x) {
            CHECK(one(x, y) == other(x, y));
        }
    }
}

TEST_CASE("at a scale of two each pixel becomes four") {
    const SrgbImage one = written("Ag");
    const SrgbImage two = written("Ag", 2);
    for (int y = 0; y < two.height(); ++y) {
        for (int x = 0; x < two.width(); ++x) {
            CHECK(two(x, y) == one(x / 2, y / 2));
        }
    }
}

TEST_CASE("between whole scales the ink stays as much as the area") {
    const auto ink = [](const SrgbImage& image) {
        double sum = 0;
        for (const Rgba8& p : image.pixels()) {
            sum += p.r / 255.0;
        }
        return sum;
    };
    CHECK(ink(written("HELLO", 1.5F)) ==
          doctest::Approx(2.25 * ink(written("HELLO"))).epsilon(0.05));
}

TEST_CASE("what is not ASCII is a question mark; what is outside is left out") {
    CHECK(written("\xC3\xA4") == written("??"));
    CHECK(written("\n") == written("?"));
    CHECK(written("A", 1, -100, 0) == SrgbImage(80, 40, black));
    CHECK(written("A", 1, 79, 39).width() == 80);
    CHECK(written("A", 3, -4, -4) != SrgbImage(80, 40, black));
}

TEST_CASE("a rectangle mixes its colour in by its opacity") {
    SrgbImage image(4, 4, white);
    shade_rectangle(image, -5, 1, 7, 2, Rgba8{0, 0, 0, 51});
    CHECK(image(0, 1) == Rgba8{204, 204, 204, 255});
    CHECK(image(1, 2) == Rgba8{204, 204, 204, 255});
    CHECK(image(2, 1) == white);
    CHECK(image(0, 0) == white);
    CHECK(image(0, 3) == white);
}

}  // namespace
}  // namespace glint
