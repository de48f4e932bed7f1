#include "tests/oracle/cases.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <set>
#include <stdexcept>

namespace glint::oracle {
namespace {

// The top-left rule, said without edges: the sample moved right by an infinitesimal, and down by a
// far smaller one, is strictly inside. On a lattice of 8 x 8 these steps are small enough.
bool covers_when_moved(const Triangle& t, Point sample) {
    constexpr int scale = 1 << 10;
    const auto large = [](Point p) { return Point{p.x * scale, p.y * scale}; };
    const Point moved{sample.x * scale + 16, sample.y * scale + 1};
    const auto& [a, b, c] = t;
    const std::int64_t areas[] = {doubled_area(large(a), large(b), moved),
                                  doubled_area(large(b), large(c), moved),
                                  doubled_area(large(c), large(a), moved)};
    return std::ranges::all_of(areas, [](auto area) { return area > 0; }) ||
           std::ranges::all_of(areas, [](auto area) { return area < 0; });
}

std::vector<Point> small_lattice() {
    std::vector<Point> points;
    for (int y = 0; y < 5; ++y) {
        for (int x = 0; x < 5; ++x) {
            points.push_back({x, y});
        }
    }
    return points;
}

TEST_CASE("the definition is the top-left rule, for every triangle on a small lattice") {
    const std::vector<Point> points = small_lattice();
    int wrong = 0;
    for (const Point a : points) {
        for (const Point b : points) {
            for (const Point c : points) {
                wrong += static_cast<int>(std::ranges::count_if(points, [&](Point sample) {
                    return covers({a, b, c}, sample) != covers_when_moved({a, b, c}, sample);
                }));
            }
        }
    }
    CHECK(wrong == 0);
}

TEST_CASE("left and top edges belong to a triangle, right and bottom edges do not") {
    const Triangle upper_left{Point{0, 0}, Point{512, 0}, Point{0, 512}};
    CHECK(covers(upper_left, {0, 0}));
    CHECK(covers(upper_left, {256, 0}));
    CHECK(covers(upper_left, {0, 256}));
    CHECK(covers(upper_left, {1, 1}));
    CHECK_FALSE(covers(upper_left, {256, 256}));
    CHECK_FALSE(covers(upper_left, {512, 0}));
    CHECK_FALSE(covers(upper_left, {0, 512}));
    const Triangle lower_right{Point{512, 512}, Point{512, 0}, Point{0, 512}};
    CHECK(covers(lower_right, {256, 256}));
    CHECK_FALSE(covers(lower_right, {0, 512}));
    CHECK_FALSE(covers(lower_right, {512, 511}));
    CHECK_FALSE(covers(lower_right, {511, 512}));
}

TEST_CASE("arithmetic is exact from corner to corner of the guard band") {
    const Point a{-guard_band, -guard_band};
    const Point b{guard_band, guard_band - 1};
    const Point c{-guard_band, guard_band};
    CHECK(doubled_area(a, b, {0, 0}) == guard_band);
    CHECK(covers({a, b, c}, {0, 0}));
    CHECK_FALSE(covers({a, b, c}, {0, -1}));
    CHECK(covers({b, c, a}, {guard_band - 1, guard_band - 1}));
}

TEST_CASE("zero area covers nothing") {
    CHECK_FALSE(covers({Point{0, 0}, Point{0, 0}, Point{0, 0}}, {0, 0}));
    CHECK_FALSE(covers({Point{0, 0}, Point{2, 0}, Point{1, 0}}, {1, 0}));
    CHECK_FALSE(covers({Point{0, 0}, Point{0, 2}, Point{0, 1}}, {0, 1}));
}

// ---- rows -------------------------------------------------------------------------------------

struct Box {
    int left, top, right, bottom;  // pixels, the last two not included
};

Box pixels_near(const Triangle& t, const Case& c) {
    const auto [left, right] = std::minmax({t[0].x, t[1].x, t[2].x});
    const auto [top, bottom] = std::minmax({t[0].y, t[1].y, t[2].y});
    return {std::max(left / 256 - 1, 0), std::max(top / 256 - 1, 0),
            std::min(right / 256 + 2, c.width), std::min(bottom / 256 + 2, c.height)};
}

std::vector<Run> runs_by_definition(const Triangle& t, Point position, const Case& c) {
    std::vector<Run> runs;
    const Box box = pixels_near(t, c);
    for (int y = box.top; y < box.bottom; ++y) {
        for (int x = box.left; x < box.right; ++x) {
            if (!covers(t, {x * 256 + position.x, y * 256 + position.y})) {
                continue;
            }
            if (!runs.empty() && runs.back().y == y && runs.back().x_end == x) {
                ++runs.back().x_end;
            } else {
                runs.push_back({y, x, x + 1});
            }
        }
    }
    return runs;
}

bool rows_are_right_everywhere(const Case& c) {
    for (const Triangle& t : c.triangles) {
        for (const Point position : sample_positions(c.samples)) {
            std::vector<Run> runs;
            append_runs(t, position, c.width, c.height, runs);
            if (runs != runs_by_definition(t, position, c)) {
                return false;
            }
        }
    }
    return true;
}

TEST_CASE("the rows of a triangle are the definition's at every pixel") {
    for (const Kind& kind : all_kinds()) {
        const bool is_mesh = !make_case(kind, 0).outline.empty();
        CAPTURE(kind.name);
        for (std::uint64_t seed = 0; seed < (is_mesh ? 100 : 1000); ++seed) {
            const Case c = make_case(kind, seed);
            if (c.width > 96) {
                continue;  // the next test's
            }
            if (!rows_are_right_everywhere(c)) {
                FAIL_CHECK("seed " << seed);
            }
        }
    }
}

bool ends_are_right(const Triangle& t, Point position, const Case& c) {
    std::vector<Run> runs;
    append_runs(t, position, c.width, c.height, runs);
    const auto covered = [&](int x, int y) {
        return covers(t, {x * 256 + position.x, y * 256 + position.y});
    };
    return std::ranges::all_of(runs, [&](const Run& run) {
        return covered(run.x_begin, run.y) && covered(run.x_end - 1, run.y) &&
               (run.x_begin == 0 || !covered(run.x_begin - 1, run.y)) &&
               (run.x_end == c.width || !covered(run.x_end, run.y));
    });
}

TEST_CASE("the rows of a triangle end where the definition says in the largest viewport") {
    for (const Kind& kind : triangle_kinds()) {
        CAPTURE(kind.name);
        for (std::uint64_t seed = 0; seed < 20; ++seed) {
            Case c = make_case(kind, seed);
            c.width = 16384;
            c.height = 16384;
            for (const Point position : sample_positions(c.samples)) {
                if (!ends_are_right(c.triangles[0], position, c)) {
                    FAIL_CHECK("seed " << seed);
                }
            }
        }
    }
}

TEST_CASE("the rows of a polygon leave out its hole and join across the tie to it") {
    const Point square_with_hole[] = {{0, 0},      {1280, 0},  {1280, 1280}, {0, 1280},
                                      {0, 0},      {512, 512}, {512, 1024},  {1024, 1024},
                                      {1024, 512}, {512, 512}};
    std::vector<Run> runs;
    append_runs(square_with_hole, {128, 128}, 8, 8, runs);
    CHECK(runs == std::vector<Run>{
                      {0, 0, 5}, {1, 0, 5}, {2, 0, 2}, {2, 4, 5}, {3, 0, 2}, {3, 4, 5}, {4, 0, 5}});
}

// ---- samples ----------------------------------------------------------------------------------

TEST_CASE("no two samples of a pixel share a row or a column, and all lie on 1/16 pixel") {
    for (const int samples : {1, 2, 4, 8, 16}) {
        CAPTURE(samples);
        std::set<int> x;
        std::set<int> y;
        for (const Point p : sample_positions(samples)) {
            CHECK(p.x % 16 == 0);
            CHECK(p.y % 16 == 0);
            CHECK(std::clamp(p.x, 0, 255) == p.x);
            CHECK(std::clamp(p.y, 0, 255) == p.y);
            x.insert(p.x);
            y.insert(p.y);
        }
        CHECK(x.size() == static_cast<std::size_t>(samples));
        CHECK(y.size() == static_cast<std::size_t>(samples));
    }
    CHECK_THROWS_AS(sample_positions(3), std::invalid_argument);
}

TEST_CASE("samples stand where Vulkan's table of standard locations has them, in its order") {
    const auto is_at = [](Point p, double x, double y) { return p.x == x * 256 && p.y == y * 256; };
    CHECK(is_at(sample_positions(1)[0], 0.5, 0.5));
    CHECK(is_at(sample_positions(2)[0], 0.75, 0.75));
    CHECK(is_at(sample_positions(4)[0], 0.375, 0.125));
    CHECK(is_at(sample_positions(4)[3], 0.625, 0.875));
    CHECK(is_at(sample_positions(8)[3], 0.3125, 0.1875));
    CHECK(is_at(sample_positions(8)[7], 0.9375, 0.0625));
    CHECK(is_at(sample_positions(16)[8], 0.375, 0.875));
    CHECK(is_at(sample_positions(16)[12], 0.0, 0.5));
    CHECK(is_at(sample_positions(16)[15], 0.0625, 0.0));
}

}  // namespace
}  // namespace glint::oracle
