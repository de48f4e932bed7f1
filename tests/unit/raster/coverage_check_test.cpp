#include "tests/oracle/check.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <map>

namespace glint::oracle {
namespace {

using Covers = std::function<bool(const Triangle&, Point sample)>;

// Asks at every pixel near the triangle, a pixel a run.
Rasterizer pixel_by_pixel(const Covers& question) {
    return [question](std::span<const Triangle> triangles, int width, int height, int samples,
                      const Emit& emit) {
        const auto positions = sample_positions(samples);
        for (std::size_t i = 0; i < triangles.size(); ++i) {
            const Triangle& t = triangles[i];
            const auto [left, right] = std::minmax({t[0].x, t[1].x, t[2].x});
            const auto [top, bottom] = std::minmax({t[0].y, t[1].y, t[2].y});
            const int x_end = std::min(right / 256 + 2, width);
            const int y_end = std::min(bottom / 256 + 2, height);
            for (int y = std::max(top / 256 - 1, 0); y < y_end; ++y) {
                for (int x = std::max(left / 256 - 1, 0); x < x_end; ++x) {
                    for (int s = 0; s < samples; ++s) {
                        const Point p = positions[static_cast<std::size_t>(s)];
                        if (question(t, {x * 256 + p.x, y * 256 + p.y})) {
                            emit(s, static_cast<int>(i), y, x, x + 1);
                        }
                    }
                }
            }
        }
    };
}

// The oracle's own rows, from the bottom, each in two pieces and from the right.
void right_in_pieces(std::span<const Triangle> triangles, int width, int height, int samples,
                     const Emit& emit) {
    for (int i = static_cast<int>(triangles.size()) - 1; i >= 0; --i) {
        for (int s = 0; s < samples; ++s) {
            std::vector<Run> runs;
            append_runs(triangles[static_cast<std::size_t>(i)],
                        sample_positions(samples)[static_cast<std::size_t>(s)], width, height,
                        runs);
            std::ranges::reverse(runs);
            for (const Run& run : runs) {
                const int middle = (run.x_begin + run.x_end) / 2;
                emit(s, i, run.y, middle, run.x_end);
                emit(s, i, run.y, run.x_begin, middle);
                emit(s, i, run.y, run.x_end, run.x_begin);  // no pixels
            }
        }
    }
}

// As it should be, but for what spoil makes of each run.
template <class Spoil>
Rasterizer spoiled(Spoil spoil) {
    return [spoil](std::span<const Triangle> triangles, int width, int height, int samples,
                   const Emit& emit) {
        right_in_pieces(triangles, width, height, samples,
                        [&](int sample, int triangle, int y, int x_begin, int x_end) {
                            spoil(emit, width, height, Run{y, x_begin, x_end}, sample, triangle);
                        });
    };
}

// ---- edges, rightly and wrongly ---------------------------------------------------------------

// Calls inside(value, a, b) for the three edges a to b, turned so that value is positive inside.
template <class Inside>
bool inside_edges(Triangle t, Point sample, Inside inside) {
    const std::int64_t area = doubled_area(t[0], t[1], t[2]);
    if (area == 0) {
        return false;
    }
    if (area < 0) {
        std::swap(t[1], t[2]);
    }
    for (std::size_t i = 0; i < 3; ++i) {
        const Point a = t[i];
        const Point b = t[(i + 1) % 3];
        if (!inside(doubled_area(a, b, sample), a, b)) {
            return false;
        }
    }
    return true;
}

bool is_top_left(Point a, Point b) {  // of a triangle that runs clockwise on the screen
    return b.y < a.y || (b.y == a.y && b.x > a.x);
}

bool with_edges_included(const Triangle& t, Point s) {
    return inside_edges(t, s, [](std::int64_t e, Point, Point) { return e >= 0; });
}

bool with_edges_excluded(const Triangle& t, Point s) {
    return inside_edges(t, s, [](std::int64_t e, Point, Point) { return e > 0; });
}

bool by_bottom_right_rule(const Triangle& t, Point s) {
    return inside_edges(t, s, [](std::int64_t e, Point a, Point b) {
        return e > 0 || (e == 0 && !is_top_left(a, b));
    });
}

bool by_top_right_rule(const Triangle& t, Point s) {
    return inside_edges(t, s, [](std::int64_t e, Point a, Point b) {
        return e > 0 || (e == 0 && (b.y > a.y || (b.y == a.y && b.x > a.x)));
    });
}

bool by_left_rule_without_top(const Triangle& t, Point s) {
    return inside_edges(
        t, s, [](std::int64_t e, Point a, Point b) { return e > 0 || (e == 0 && b.y < a.y); });
}

bool with_edges_truncated(const Triangle& t, Point s) {  // towards zero, where floor is right
    return inside_edges(t, s, [](std::int64_t e, Point a, Point b) {
        return (e - (is_top_left(a, b) ? 0 : 1)) / 256 >= 0;
    });
}

bool with_edges_in_32_bits(const Triangle& t, Point s) {
    return inside_edges(t, s, [](std::int64_t e, Point a, Point b) {
        return static_cast<std::int32_t>(e - (is_top_left(a, b) ? 0 : 1)) >= 0;
    });
}

float float_edge(Point a, Point b, Point s) {
    const auto px = [](int units) { return static_cast<float>(units) / 256.0F; };
    return (px(b.x) - px(a.x)) * (px(s.y) - px(a.y)) - (px(b.y) - px(a.y)) * (px(s.x) - px(a.x));
}

bool in_float_without_rule(const Triangle& t, Point s) {
    const float e[] = {float_edge(t[0], t[1], s), float_edge(t[1], t[2], s),
                       float_edge(t[2], t[0], s)};
    return std::ranges::all_of(e, [](float x) { return x >= 0; }) ||
           std::ranges::all_of(e, [](float x) { return x <= 0; });
}

bool in_float_with_rule(const Triangle& t, Point s) {
    return inside_edges(t, s, [&](std::int64_t, Point a, Point b) {
        const float e = float_edge(a, b, s);
        return e > 0 || (e == 0 && is_top_left(a, b));
    });
}

bool of_one_winding(const Triangle& t, Point s) {
    return doubled_area(t[0], t[1], t[2]) > 0 && covers(t, s);
}

Triangle mapped(const Triangle& t, int (*map)(int)) {
    return {Point{map(t[0].x), map(t[0].y)}, Point{map(t[1].x), map(t[1].y)},
            Point{map(t[2].x), map(t[2].y)}};
}

bool snapped_to_sixteenths(const Triangle& t, Point s) {
    return covers(mapped(t, [](int v) { return (v + 8) / 16 * 16; }), s);
}

bool snapped_one_unit_off(const Triangle& t, Point s) {
    return covers(mapped(t, [](int v) { return v + 1; }), s);
}

bool at_pixel_centres(const Triangle& t, Point s) {
    return covers(t, {(s.x & ~255) + 128, (s.y & ~255) + 128});
}

bool at_mirrored_samples(const Triangle& t, Point s) {
    return covers(t, {s.x, (s.y & ~255) + 256 - (s.y & 255)});
}

void without_last_column(const Emit& emit, int width, int, Run run, int sample, int triangle) {
    emit(sample, triangle, run.y, run.x_begin, std::min(run.x_end, width - 1));
}

void without_last_row(const Emit& emit, int, int height, Run run, int sample, int triangle) {
    if (run.y < height - 1) {
        emit(sample, triangle, run.y, run.x_begin, run.x_end);
    }
}

void in_a_larger_viewport(std::span<const Triangle> triangles, int width, int height, int samples,
                          const Emit& emit) {
    right_in_pieces(triangles, width + 1, height + 1, samples, emit);
}

void some_pixels_twice(const Emit& emit, int, int, Run run, int sample, int triangle) {
    emit(sample, triangle, run.y, run.x_begin, run.x_end);
    emit(sample, triangle, run.y, run.x_end - (run.y % 8 == 0 ? 1 : 0), run.x_end);
}

void of_the_next_triangle(const Emit& emit, int, int, Run run, int sample, int triangle) {
    emit(sample, triangle + 1, run.y, run.x_begin, run.x_end);
}

const std::map<std::string, Rasterizer>& wrong_rasterizers() {
    static const std::map<std::string, Rasterizer> wrong{
        {"edges included", pixel_by_pixel(with_edges_included)},
        {"edges excluded", pixel_by_pixel(with_edges_excluded)},
        {"bottom-right rule", pixel_by_pixel(by_bottom_right_rule)},
        {"top-right rule", pixel_by_pixel(by_top_right_rule)},
        {"left rule without top", pixel_by_pixel(by_left_rule_without_top)},
        {"edge values truncated", pixel_by_pixel(with_edges_truncated)},
        {"edge values in 32 bits", pixel_by_pixel(with_edges_in_32_bits)},
        {"edge values in float, no rule", pixel_by_pixel(in_float_without_rule)},
        {"edge values in float", pixel_by_pixel(in_float_with_rule)},
        {"one winding only", pixel_by_pixel(of_one_winding)},
        {"vertices snapped to 1/16 px", pixel_by_pixel(snapped_to_sixteenths)},
        {"vertices one unit off", pixel_by_pixel(snapped_one_unit_off)},
        {"samples all at the centre", pixel_by_pixel(at_pixel_centres)},
        {"samples upside down", pixel_by_pixel(at_mirrored_samples)},
        {"last column lost", spoiled(without_last_column)},
        {"last row lost", spoiled(without_last_row)},
        {"a row and a column too many", in_a_larger_viewport},
        {"some pixels twice", spoiled(some_pixels_twice)},
        {"triangles misnumbered", spoiled(of_the_next_triangle)},
    };
    return wrong;
}

TEST_CASE("right rasterizers pass, whatever the order and the length of their runs") {
    const Verdict pixels = check_all(pixel_by_pixel(covers), 1000);
    CHECK_MESSAGE(pixels.failures == 0, pixels.report);
    CHECK(pixels.report.empty());
    const Verdict rows = check_all(right_in_pieces, 20000);
    CHECK_MESSAGE(rows.failures == 0, rows.report);
    CHECK(rows.cases >= 20000);
    CHECK(rows.failing_kinds.empty());
}

TEST_CASE("each wrong rasterizer is caught, and each kind catches some") {
    std::map<std::string_view, int> caught;
    for (const auto& [name, rasterizer] : wrong_rasterizers()) {
        const Verdict verdict = check_all(rasterizer, 400);
        MESSAGE(name << ": caught by " << verdict.failing_kinds.size() << " kinds, in "
                     << verdict.failures << " of " << verdict.cases << " cases");
        CHECK(verdict.failing_kinds.size() > 0);
        for (const std::string_view kind : verdict.failing_kinds) {
            ++caught[kind];
        }
    }
    for (const Kind& kind : all_kinds()) {
        CAPTURE(kind.name);
        CHECK(caught[kind.name] > 0);
    }
}

// ---- words --------------------------------------------------------------------------------------

Case one_square() {
    Case c;
    c.kind = "square";
    c.seed = 5;
    c.width = 6;
    c.height = 4;
    c.triangles = {{Point{256, 256}, Point{1024, 256}, Point{256, 768}},
                   {Point{1024, 768}, Point{1024, 256}, Point{256, 768}}};
    c.outline = {{256, 256}, {1024, 256}, {1024, 768}, {256, 768}};
    return c;
}

TEST_CASE("a failure names the case, the triangle and the pixel, and draws them") {
    const Rasterizer shifted = spoiled([](const Emit& emit, int, int, Run run, int s, int t) {
        emit(s, t, run.y, run.x_begin + 1, run.x_end + 1);
    });
    CHECK(check(shifted, one_square()) ==
          "square, seed 5, 6 x 4 pixels of 1 samples:\n"
          "  triangle 0 of 2 (256, 256) (1024, 256) (256, 768) in 1/256 px\n"
          "  sample 0 of pixel (1, 1) is missing; of the whole mesh it is covered 0 times\n"
          "  columns 0 to 5, rows 0 to 3:\n"
          "    ......\n"
          "  > .?#!..\n"
          "    .?!...\n"
          "    ......\n"
          "     ^\n");
}

TEST_CASE("a failure outside the viewport or of no triangle is told, too") {
    const auto also = [](int triangle, int y, int x) {
        return [=](std::span<const Triangle> triangles, int width, int height, int samples,
                   const Emit& emit) {
            right_in_pieces(triangles, width, height, samples, emit);
            emit(0, triangle, y, x, x + 1);
        };
    };
    const auto says = [](const std::string& text, const char* words) {
        INFO(text);
        CHECK(text.find(words) != std::string::npos);
    };
    says(check(also(1, 1, 6), one_square()), "pixel (6, 1) is extra");
    says(check(also(1, 4, 5), one_square()), "pixel (5, 4) is extra");
    says(check(also(0, -1, -2), one_square()), "pixel (-2, -1) is extra");
    says(check(also(2, 1, 1), one_square()), "triangle 2 of 2, which there is not");
    says(check(also(-1, 1, 1), one_square()), "triangle -1 of 2, which there is not");
    says(check(also(0, 1, 1), one_square()), "pixel (1, 1) is emitted 2 times");
    CHECK(check(right_in_pieces, one_square()).empty());
}

TEST_CASE("a verdict counts failures and quotes the first of each kind") {
    const Verdict verdict = check_all(pixel_by_pixel(with_edges_excluded), 440);
    CHECK(verdict.cases == 440);
    CHECK(verdict.failures >= static_cast<int>(verdict.failing_kinds.size()));
    for (const std::string_view kind : verdict.failing_kinds) {
        CHECK(verdict.report.find(std::string(kind) + ", seed ") != std::string::npos);
    }
}

}  // namespace
}  // namespace glint::oracle
