// Which pixels a triangle covers: where float, 32 bits, no rule or a coarse grid decide it.
#include "framework/raster/coverage.hpp"

#include "lessons/18_scanline_to_tiles/scanline_to_tiles.hpp"
#include "framework/raster/plug.hpp"
#include "tests/stability/row.hpp"
#include "tests/unit/raster/drawing.hpp"

#include <algorithm>
#include <numeric>

namespace glint::stability {
namespace {

constexpr int side = 48;  // pixels of the square window
using Corners = std::array<glm::vec2, 3>;

// How many triangles, and the last of them, a pixel has.
struct Pixel {
    int count = 0;
    int owner = -1;
};
using Pixels = Image<Pixel>;

template <class Covers>
Pixels by_asking(std::span<const Corners> triangles, Covers covers) {
    Pixels pixels(side, side);
    for (std::size_t i = 0; i < triangles.size(); ++i) {
        for (int y = 0; y < side; ++y) {
            for (int x = 0; x < side; ++x) {
                if (covers(triangles[i], glm::vec2(x, y) + 0.5F)) {
                    pixels(x, y) = {pixels(x, y).count + 1, static_cast<int>(i)};
                }
            }
        }
    }
    return pixels;
}

Pixels by_glint(std::span<const Corners> triangles, const Settings& settings, int bits = 8) {
    std::vector<std::array<glm::ivec2, 3>> snapped(triangles.size());
    for (std::size_t i = 0; i < triangles.size(); ++i) {
        std::ranges::transform(triangles[i], snapped[i].begin(), [&](const glm::vec2& p) {
            return glm::ivec2(by_hand::snapped(p.x, bits), by_hand::snapped(p.y, bits));
        });
    }
    Pixels pixels(side, side);
    find_coverage(snapped, side, side, settings, [&](int, int triangle, int y, int x, int end) {
        for (; x < end; ++x) {
            pixels(x, y) = {pixels(x, y).count + 1, triangle};
        }
    });
    return pixels;
}

int not_once(const Pixels& pixels) {
    return static_cast<int>(
        std::ranges::count_if(pixels.pixels(), [](const Pixel& p) { return p.count != 1; }));
}

int differing(const Pixels& a, const Pixels& b) {
    return std::inner_product(
        a.pixels().begin(), a.pixels().end(), b.pixels().begin(), 0, std::plus<>(),
        [](const Pixel& p, const Pixel& q) { return p.owner != q.owner ? 1 : 0; });
}

// E of the edge from p to q at s as a x + b y + c, in T.
template <Real T>
double edge_at(const glm::vec2& p, const glm::vec2& q, const glm::vec2& s) {
    const T a = T(p.y) - T(q.y);
    const T b = T(q.x) - T(p.x);
    const T c = -(a * T(p.x) + b * T(p.y));
    return value(a * T(s.x) + (b * T(s.y) + c));
}

// With the rule for a sample on an edge: any(e, p, q) says whether it is in.
template <Real T, class Rule>
bool inside(const Corners& v, const glm::vec2& s, Rule rule) {
    for (std::size_t i = 0; i < 3; ++i) {
        const glm::vec2 p = v[i];
        const glm::vec2 q = v[(i + 1) % 3];
        const double e = edge_at<T>(p, q, s);
        if (!(e > 0 || (e == 0 && rule(p, q)))) {
            return false;
        }
    }
    return true;
}
bool top_left(const glm::vec2& p, const glm::vec2& q) {
    return p.y > q.y || (p.y == q.y && q.x > p.x);
}

// Dark where no triangle is, grey for one, magenta for more.
Rgb<float> colour_of_count(const Pixel& p) {
    return p.count == 0 ? Rgb<float>(0) : p.count == 1 ? Rgb<float>(0.3F) : Rgb<float>(1, 0, 0.5F);
}
void draw_counts(const std::string& name, const Pixels& naive, const Pixels& glint) {
    picture(
        name, side, side, 4, [&](int x, int y) { return colour_of_count(naive(x, y)); },
        [&](int x, int y) { return colour_of_count(glint(x, y)); });
}

// Strips of a pixel's height along lines through pixel centres, with corners on the grid of 1/256
// pixel some 10000 pixels away.
std::vector<Corners> long_slivers(const glm::vec2& slope, float left_end, float right_end) {
    std::vector<Corners> strips;
    for (int j = -2 * side; j < 2 * side; ++j) {
        const glm::vec2 on_line(0.5F, 0.5F + static_cast<float>(j));
        const glm::vec2 left = on_line - (left_end + 37 / 256.0F) * slope;
        const glm::vec2 right = on_line + (right_end + 91 / 256.0F) * slope;
        const glm::vec2 down(0, 1);
        strips.push_back({left, right, left + down});
        strips.push_back({right, right + down, left + down});
    }
    return strips;
}

TEST_CASE("edge functions in float: long slivers along pixel centres") {
    const auto naive = []<Real T>(const std::vector<Corners>& strips) {
        return by_asking(
            strips, [](const Corners& v, const glm::vec2& s) { return inside<T>(v, s, top_left); });
    };
    const auto meshes = {long_slivers({3, 1}, 4001, 3999), long_slivers({5, -2}, 2003, 2501),
                         long_slivers({7, 3}, 1801, 1703), long_slivers({2, 1}, 6007, 7001)};
    const auto steep = long_slivers({5, -2}, 2003, 2501);
    draw_counts("float_edges", naive.operator()<float>(steep), by_glint(steep, {}));
    row(in_all_numbers([&]<Real T>() {
            Errors sum;
            for (const auto& strips : meshes) {
                sum.naive += not_once(naive.operator()<T>(strips));
                sum.glint += not_once(by_glint(strips, settings_of<T>()));
            }
            return sum;
        }),
        200, 0);
}

// As in 32 bits on a grid of 1/256 pixel: what does not fit wraps.
bool inside_32_bits(const Corners& v, const glm::vec2& s) {
    const auto fixed = [](float x) { return static_cast<std::uint32_t>(round_to_int(x * 256)); };
    for (std::size_t i = 0; i < 3; ++i) {
        const glm::vec2 p = v[i];
        const glm::vec2 q = v[(i + 1) % 3];
        const std::uint32_t e = (fixed(p.y) - fixed(q.y)) * (fixed(s.x) - fixed(p.x)) +
                                (fixed(q.x) - fixed(p.x)) * (fixed(s.y) - fixed(p.y));
        if (static_cast<std::int32_t>(e) < 0) {
            return false;
        }
    }
    return true;
}

TEST_CASE("edge functions in 32 bits: a triangle beyond the guard band") {
    const std::vector<Corners> one{{{{-100000, 10}, {90000, 40}, {300, 250000}}}};
    Mesh mesh;
    for (const glm::vec2& p : one[0]) {
        mesh.positions.emplace_back(p, 0.5F);
    }
    mesh.triangles = {{0, 1, 2}};
    const auto drawn = [&](const Settings& settings) {
        return draw(mesh, window_view(side, side), plug(show_uv), settings).triangle;
    };
    // What lies nearer to the edge than clipping moves it counts as right.
    const auto wrong = [&](const auto& covered) {
        int pixels = 0;
        for (int y = 0; y < side; ++y) {
            for (int x = 0; x < side; ++x) {
                const double e = edge_at<double>(one[0][0], one[0][1], glm::vec2(x, y) + 0.5F);
                pixels += std::abs(e) > 190000 * 0.01 && covered(x, y) != (e > 0) ? 1 : 0;
            }
        }
        return double{1.0 * pixels};
    };
    const Pixels wrapped = by_asking(one, inside_32_bits);
    const auto shown = drawn({});
    picture(
        "edges_32_bits", side, side, 4,
        [&](int x, int y) { return colour_of_count(wrapped(x, y)); },
        [&](int x, int y) {
            return colour_of_count({shown(x, y) + 1, 0});
        });
    row(in_all_numbers([&]<Real T>() {
            const auto owner = drawn(settings_of<T>());
            return Errors{wrong([&](int x, int y) { return wrapped(x, y).count == 1; }),
                          wrong([&](int x, int y) { return owner(x, y) == 0; })};
        }),
        300, 0);
}

TEST_CASE("no fill rule: edges through pixel centres") {
    std::vector<Corners> grid;
    for (float y = -3.5F; y < side; y += 8) {
        for (float x = -3.5F; x < side; x += 8) {
            grid.push_back({glm::vec2(x, y), glm::vec2(x + 8, y), glm::vec2(x, y + 8)});
            grid.push_back({glm::vec2(x + 8, y), glm::vec2(x + 8, y + 8), glm::vec2(x, y + 8)});
        }
    }
    const auto naive = [&]<Real T>(bool in) {
        return by_asking(grid, [in](const Corners& v, const glm::vec2& s) {
            return inside<T>(v, s, [in](const glm::vec2&, const glm::vec2&) { return in; });
        });
    };
    draw_counts("no_fill_rule", naive.operator()<float>(true), by_glint(grid, {}));
    CHECK(not_once(naive.operator()<double>(true)) > 700);   // drawn twice and more
    CHECK(not_once(naive.operator()<double>(false)) > 700);  // not drawn
    row(in_all_numbers([&]<Real T>() {
            return Errors{1.0 * not_once(naive.operator()<T>(true)),
                          1.0 * not_once(by_glint(grid, settings_of<T>()))};
        }),
        700, 0);
}

// Leaning cells of about 0.7 pixel, two triangles each, over the whole window.
std::vector<Corners> tiny_triangles() {
    std::vector<Corners> all;
    for (int row = -50; row < 130; ++row) {
        for (int column = -50; column < 130; ++column) {
            const auto at = [](int i, int j) {
                return glm::vec2(0.71F * static_cast<float>(i) + 0.23F * static_cast<float>(j),
                                 0.67F * static_cast<float>(j) - 0.19F * static_cast<float>(i));
            };
            const glm::vec2 middle = at(column, row);
            if (std::min(middle.x, middle.y) < -2 || std::max(middle.x, middle.y) > side + 2) {
                continue;
            }
            all.push_back({at(column, row), at(column + 1, row), at(column, row + 1)});
            all.push_back({at(column + 1, row), at(column + 1, row + 1), at(column, row + 1)});
        }
    }
    return all;
}

// The share of pixels that go to another triangle than they lie in.
void sub_pixel_row(int bits, double fails) {
    const std::vector<Corners> tiny = tiny_triangles();
    const Pixels truth = by_asking(
        tiny, [](const Corners& v, const glm::vec2& s) { return inside<double>(v, s, top_left); });
    constexpr double all = side * side;
    row(in_all_numbers([&]<Real T>() {
            return Errors{differing(by_glint(tiny, settings_of<T>(), bits), truth) / all,
                          differing(by_glint(tiny, settings_of<T>()), truth) / all};
        }),
        fails, 0.03);
    const auto shade = [&truth](const Pixels& pixels) {
        return [&truth, pixels](int x, int y) {
            const bool right = pixels(x, y).owner == truth(x, y).owner;
            return colour_of_count({right ? 1 : 2, 0});
        };
    };
    picture("bits_" + std::to_string(bits), side, side, 4, shade(by_glint(tiny, {}, bits)),
            shade(by_glint(tiny, {})));
}
TEST_CASE("0 sub-pixel bits: triangles smaller than a pixel") {
    sub_pixel_row(0, 0.5);
}
TEST_CASE("4 sub-pixel bits: triangles smaller than a pixel") {
    sub_pixel_row(4, 0.05);
}

}  // namespace
}  // namespace glint::stability
