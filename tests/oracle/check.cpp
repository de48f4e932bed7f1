#include "tests/oracle/check.hpp"

#include <algorithm>
#include <sstream>
#include <tuple>

namespace glint::oracle {
namespace {

struct Covered {
    int triangle, sample, y, x_begin, x_end;
    friend bool operator==(const Covered&, const Covered&) = default;
};

auto row_of(const Covered& run) {
    return std::tie(run.triangle, run.sample, run.y);
}

bool before(const Covered& a, const Covered& b) {
    return std::tuple(row_of(a), a.x_begin, a.x_end) < std::tuple(row_of(b), b.x_begin, b.x_end);
}

// In order, pieces joined. What overlaps stays apart: it was emitted twice.
void tidy(std::vector<Covered>& runs) {
    if (!std::is_sorted(runs.begin(), runs.end(), before)) {
        std::sort(runs.begin(), runs.end(), before);
    }
    std::size_t count = 0;
    for (const Covered& run : runs) {
        if (count > 0 && row_of(runs[count - 1]) == row_of(run) &&
            runs[count - 1].x_end == run.x_begin) {
            runs[count - 1].x_end = run.x_end;
        } else {
            runs[count++] = run;
        }
    }
    runs.resize(count);
}

std::vector<Covered> covered_by_oracle(const Case& c) {
    std::vector<Covered> covered;
    std::vector<Run> runs;
    const auto positions = sample_positions(c.samples);
    for (int t = 0; t < static_cast<int>(c.triangles.size()); ++t) {
        for (int s = 0; s < c.samples; ++s) {
            runs.clear();
            append_runs(c.triangles[static_cast<std::size_t>(t)],
                        positions[static_cast<std::size_t>(s)], c.width, c.height, runs);
            for (const Run& run : runs) {
                covered.push_back({t, s, run.y, run.x_begin, run.x_end});
            }
        }
    }
    return covered;
}

std::vector<Covered> covered_by(const Rasterizer& rasterizer, const Case& c) {
    std::vector<Covered> covered;
    rasterizer(c.triangles, c.width, c.height, c.samples,
               [&](int sample, int triangle, int y, int x_begin, int x_end) {
                   if (x_begin < x_end) {
                       covered.push_back({triangle, sample, y, x_begin, x_end});
                   }
               });
    tidy(covered);
    return covered;
}

struct Pixel {
    int triangle, sample, x, y;
};

long times(const std::vector<Covered>& runs, const Pixel& p) {
    const auto [begin, end] =
        std::equal_range(runs.begin(), runs.end(), Covered{p.triangle, p.sample, p.y, 0, 0},
                         [](const Covered& a, const Covered& b) { return row_of(a) < row_of(b); });
    return std::count_if(begin, end,
                         [&](const Covered& run) { return run.x_begin <= p.x && p.x < run.x_end; });
}

struct Comparison {
    const Case& c;
    std::vector<Covered> expected, actual;
};

Pixel first_wrong(const Comparison& both) {
    const auto [e, a] = std::mismatch(both.expected.begin(), both.expected.end(),
                                      both.actual.begin(), both.actual.end());
    const bool expected_first =
        a == both.actual.end() || (e != both.expected.end() && before(*e, *a));
    const Covered& run = expected_first ? *e : *a;
    Pixel p{run.triangle, run.sample, run.x_begin, run.y};
    while (times(both.expected, p) == times(both.actual, p)) {
        ++p.x;
    }
    return p;
}

char symbol(const Comparison& both, const Pixel& p) {
    const auto expected = times(both.expected, p);
    const auto actual = times(both.actual, p);
    if (expected == actual) {
        return expected == 0 ? '.' : '#';
    }
    return expected < actual ? '!' : '?';
}

void draw(std::ostream& out, const Comparison& both, const Pixel& wrong) {
    constexpr int reach_x = 24;
    constexpr int reach_y = 6;
    // A pixel outside the viewport may be the wrong one.
    const int left = std::min(std::max(wrong.x - reach_x, 0), wrong.x);
    const int right = std::max(std::min(wrong.x + reach_x, both.c.width - 1), wrong.x);
    const int top = std::min(std::max(wrong.y - reach_y, 0), wrong.y);
    const int bottom = std::max(std::min(wrong.y + reach_y, both.c.height - 1), wrong.y);
    out << "  columns " << left << " to " << right << ", rows " << top << " to " << bottom << ":\n";
    for (int y = top; y <= bottom; ++y) {
        out << (y == wrong.y ? "  > " : "    ");
        for (int x = left; x <= right; ++x) {
            out << symbol(both, {wrong.triangle, wrong.sample, x, y});
        }
        out << '\n';
    }
    out << "    " << std::string(static_cast<std::size_t>(wrong.x - left), ' ') << "^\n";
}

void describe_triangle(std::ostream& out, const Case& c, const Pixel& p) {
    const auto count = c.triangles.size();
    out << "triangle " << p.triangle << " of " << count;
    if (p.triangle < 0 || static_cast<std::size_t>(p.triangle) >= count) {
        out << ", which there is not";
        return;
    }
    for (const Point& v : c.triangles[static_cast<std::size_t>(p.triangle)]) {
        out << " (" << v.x << ", " << v.y << ')';
    }
    out << " in 1/256 px";
}

void describe_wrong(std::ostream& out, const Comparison& both, const Pixel& wrong) {
    const auto emitted = times(both.actual, wrong);
    out << "  sample " << wrong.sample << " of pixel (" << wrong.x << ", " << wrong.y << ") is ";
    if (emitted == 0) {
        out << "missing";
    } else if (emitted == 1) {
        out << "extra";
    } else {
        out << "emitted " << emitted << " times";
    }
    if (!both.c.outline.empty()) {
        long in_mesh = 0;
        for (int t = 0; t < static_cast<int>(both.c.triangles.size()); ++t) {
            in_mesh += times(both.actual, {t, wrong.sample, wrong.x, wrong.y});
        }
        out << "; of the whole mesh it is covered " << in_mesh << " times";
    }
    out << '\n';
}

}  // namespace

std::string check(const Rasterizer& rasterizer, const Case& c) {
    const Comparison both{c, covered_by_oracle(c), covered_by(rasterizer, c)};
    if (both.expected == both.actual) {
        return {};
    }
    const Pixel wrong = first_wrong(both);
    std::ostringstream out;
    out << c.kind << ", seed " << c.seed << ", " << c.width << " x " << c.height << " pixels of "
        << c.samples << " samples:\n  ";
    describe_triangle(out, c, wrong);
    out << '\n';
    describe_wrong(out, both, wrong);
    draw(out, both, wrong);
    return out.str();
}

Verdict check_all(const Rasterizer& rasterizer, int cases, std::uint64_t seed) {
    const std::vector<Kind> kinds = all_kinds();
    const int kind_count = static_cast<int>(kinds.size());
    const int of_each = (cases + kind_count - 1) / kind_count;
    Verdict verdict;
    verdict.cases = of_each * kind_count;
    for (const Kind& kind : kinds) {
        int failures = 0;
        for (int i = 0; i < of_each; ++i) {
            const std::string wrong =
                check(rasterizer, make_case(kind, seed + static_cast<std::uint64_t>(i)));
            if (!wrong.empty() && failures++ == 0) {
                verdict.report += wrong;
            }
        }
        if (failures > 0) {
            verdict.failures += failures;
            verdict.failing_kinds.push_back(kind.name);
            verdict.report += "  " + std::to_string(failures) + " of " + std::to_string(of_each) +
                              " cases of this kind are wrong\n";
        }
    }
    return verdict;
}

}  // namespace glint::oracle
