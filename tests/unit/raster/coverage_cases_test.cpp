#include "tests/oracle/cases.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <set>

namespace glint::oracle {
namespace {

Kind kind_named(std::string_view name) {
    const std::vector<Kind> kinds = all_kinds();
    const auto kind = std::ranges::find(kinds, name, &Kind::name);
    REQUIRE(kind != kinds.end());
    return *kind;
}

// How many of the first thousand cases of a kind have a property.
template <class Property>
int count_of(std::string_view kind, Property property) {
    int count = 0;
    for (std::uint64_t seed = 0; seed < 1000; ++seed) {
        count += property(make_case(kind_named(kind), seed)) ? 1 : 0;
    }
    return count;
}

std::int64_t doubled_area(const Triangle& t) {
    return doubled_area(t[0], t[1], t[2]);
}

double longest_side(const Triangle& t) {  // in pixels
    const auto length = [](Point a, Point b) {
        return std::hypot(a.x - b.x, a.y - b.y) / units_per_pixel;
    };
    return std::max({length(t[0], t[1]), length(t[1], t[2]), length(t[2], t[0])});
}

std::int64_t covered_samples(const Case& c, std::span<const Point> polygon) {
    std::int64_t covered = 0;
    std::vector<Run> runs;
    for (const Point position : sample_positions(c.samples)) {
        append_runs(polygon, position, c.width, c.height, runs);
    }
    for (const Run& run : runs) {
        covered += run.x_end - run.x_begin;
    }
    return covered;
}

TEST_CASE("a seed makes the same case every time, and each seed another") {
    for (const Kind& kind : all_kinds()) {
        CAPTURE(kind.name);
        CHECK(make_case(kind, 7).triangles == make_case(kind, 7).triangles);
        CHECK(make_case(kind, 7).outline == make_case(kind, 7).outline);
        CHECK(make_case(kind, 7).triangles != make_case(kind, 8).triangles);
    }
}

std::uint64_t digest(std::uint64_t so_far, Point p) {  // Fowler, Noll, Vo: FNV-1a
    for (const std::int32_t x : {p.x, p.y}) {
        so_far = (so_far ^ static_cast<std::uint32_t>(x)) * 0x100000001b3;
    }
    return so_far;
}

TEST_CASE("a seed makes the same case with every compiler") {
    std::uint64_t all = 0xcbf29ce484222325;
    for (const Kind& kind : all_kinds()) {
        for (std::uint64_t seed = 0; seed < 20; ++seed) {
            const Case c = make_case(kind, seed);
            all = digest(all, {c.width, c.height});
            for (const Triangle& t : c.triangles) {
                all = digest(digest(digest(all, t[0]), t[1]), t[2]);
            }
        }
    }
    CHECK(all == 12946840949457459138U);
}

TEST_CASE("the kinds have different names, and are triangles or meshes as they say") {
    std::set<std::string_view> names;
    for (const Kind& kind : triangle_kinds()) {
        names.insert(kind.name);
        CHECK(make_case(kind, 1).triangles.size() == 1);
        CHECK(make_case(kind, 1).outline.empty());
    }
    for (const Kind& kind : mesh_kinds()) {
        names.insert(kind.name);
        CHECK(make_case(kind, 1).triangles.size() > 1);
        CHECK(make_case(kind, 1).outline.size() > 2);
    }
    CHECK(names.size() == all_kinds().size());
}

TEST_CASE("cases stay in the guard band, and their viewports and samples in range") {
    std::set<int> sample_counts;
    int large = 0;
    for (const Kind& kind : all_kinds()) {
        CAPTURE(kind.name);
        bool in_guard_band = true;
        bool in_range = true;
        for (std::uint64_t seed = 0; seed < 1000; ++seed) {
            const Case c = make_case(kind, seed);
            for (const Triangle& t : c.triangles) {
                for (const Point p : t) {
                    in_guard_band &= std::abs(p.x) <= guard_band && std::abs(p.y) <= guard_band;
                }
            }
            in_range &= c.width >= 16 && c.height >= 16 && c.width <= 4096 && c.height <= 2304;
            in_range &= c.triangles.size() <= 300;
            sample_counts.insert(c.samples);
            large += c.width > 96 ? 1 : 0;
        }
        CHECK(in_guard_band);
        CHECK(in_range);
    }
    CHECK(sample_counts == std::set<int>{1, 2, 4, 8, 16});
    CHECK(large > 0);
}

TEST_CASE("every kind reaches the viewport often, but those that must not") {
    for (const Kind& kind : all_kinds()) {
        CAPTURE(kind.name);
        const bool must_not = kind.name == "zero area" || kind.name == "beyond the viewport";
        const int visible = count_of(kind.name, [](const Case& c) {
            return std::ranges::any_of(
                c.triangles, [&](const Triangle& t) { return covered_samples(c, t) > 0; });
        });
        if (must_not) {
            CHECK(visible == 0);
        } else {
            CHECK(visible > 100);
        }
    }
}

// ---- what the kinds promise -------------------------------------------------------------------

TEST_CASE("slivers are at most two units thick and up to thousands of pixels long") {
    double longest = 0;
    CHECK(count_of("slivers", [&](const Case& c) {
              const Triangle& t = c.triangles[0];
              longest = std::max(longest, longest_side(t));
              const double base = longest_side(t) * units_per_pixel;
              return std::abs(static_cast<double>(doubled_area(t))) <= 2.5 * std::max(base, 1.0);
          }) == 1000);
    CHECK(longest > 4000);
}

TEST_CASE("zero area is zero area, with and without a repeated vertex") {
    CHECK(count_of("zero area", [](const Case& c) { return doubled_area(c.triangles[0]) != 0; }) ==
          0);
    const int repeated = count_of("zero area", [](const Case& c) {
        const Triangle& t = c.triangles[0];
        return t[0] == t[1] || t[1] == t[2] || t[2] == t[0];
    });
    CHECK(repeated > 100);
    CHECK(repeated < 900);
}

TEST_CASE("sub-pixel triangles fit a pixel's width") {
    CHECK(count_of("sub-pixel triangles", [](const Case& c) {
              return longest_side(c.triangles[0]) <= std::sqrt(2.0);
          }) == 1000);
}

TEST_CASE("some edges are horizontal, some vertical, some next to it") {
    const auto has_edge = [](auto property) {
        return [property](const Case& c) {
            const auto& [a, b, d] = c.triangles[0];
            return property(a, b) || property(b, d) || property(d, a);
        };
    };
    const char* const kind = "horizontal and vertical edges";
    CHECK(count_of(kind, has_edge([](Point p, Point q) { return p.y == q.y; })) > 500);
    CHECK(count_of(kind, has_edge([](Point p, Point q) { return p.x == q.x; })) > 500);
    CHECK(count_of(kind, has_edge([](Point p, Point q) { return std::abs(p.y - q.y) == 1; })) > 50);
}

// The least doubled area, but zero, of an edge and a sample near it.
bool has_sample_at(const Case& c, std::int64_t distance) {
    const Triangle& t = c.triangles[0];
    for (int y = 0; y < c.height; ++y) {
        for (int x = 0; x < c.width; ++x) {
            for (const Point s : sample_positions(c.samples)) {
                const Point sample{x * 256 + s.x, y * 256 + s.y};
                for (std::size_t i = 0; i < 3; ++i) {
                    if (std::abs(doubled_area(t[i], t[(i + 1) % 3], sample)) == distance) {
                        return true;
                    }
                }
            }
        }
    }
    return false;
}

TEST_CASE("edges meet samples exactly, or miss them by the least area") {
    for (std::uint64_t seed = 0; seed < 200; ++seed) {
        const Case through = make_case(kind_named("edges through samples"), seed);
        const Case near = make_case(kind_named("edges that just miss samples"), seed);
        CAPTURE(seed);
        CHECK(has_sample_at(through, 0));
        CHECK(has_sample_at(near, 1));
    }
}

TEST_CASE("over the whole viewport: most cases cover all samples, others just not") {
    const int full = count_of("over the whole viewport", [](const Case& c) {
        return covered_samples(c, c.triangles[0]) == std::int64_t{c.width} * c.height * c.samples;
    });
    CHECK(full > 500);
    CHECK(full < 1000);
}

TEST_CASE("the guard band is used up to its corners") {
    const auto is_corner = [](Point p) {
        return std::abs(p.x) == guard_band && std::abs(p.y) == guard_band;
    };
    CHECK(count_of("across the guard band", [&](const Case& c) {
              return std::ranges::any_of(c.triangles[0], is_corner);
          }) > 100);
}

// ---- meshes -----------------------------------------------------------------------------------

// How often the triangles cover each pixel's sample, less what the outline says.
bool covers_outline_once(const Case& c, Point position) {
    std::vector<int> times(static_cast<std::size_t>(c.width) * static_cast<std::size_t>(c.height));
    const auto add = [&](std::span<const Point> polygon, int amount) {
        std::vector<Run> runs;
        append_runs(polygon, position, c.width, c.height, runs);
        for (const Run& run : runs) {
            for (int x = run.x_begin; x < run.x_end; ++x) {
                times[static_cast<std::size_t>(std::int64_t{run.y} * c.width + x)] += amount;
            }
        }
    };
    add(c.outline, -1);
    for (const Triangle& t : c.triangles) {
        add(t, 1);
    }
    return std::ranges::all_of(times, [](int n) { return n == 0; });
}

TEST_CASE("a mesh covers each sample inside its outline exactly once, and none outside") {
    for (const Kind& kind : mesh_kinds()) {
        CAPTURE(kind.name);
        for (std::uint64_t seed = 0; seed < 1000; ++seed) {
            const Case c = make_case(kind, seed);
            for (const Point position : sample_positions(c.samples)) {
                if (!covers_outline_once(c, position)) {
                    FAIL_CHECK("seed " << seed);
                }
            }
        }
    }
}

}  // namespace
}  // namespace glint::oracle
