#include "lessons/18_scanline_to_tiles/cover.hpp"
#include "lessons/18_scanline_to_tiles/grids.hpp"
#include "tests/oracle/check.hpp"
#include "tests/unit/math/lane_types.hpp"

#include <doctest/doctest.h>

#include <map>
#include <tuple>

namespace glint {
namespace {

using by_hand::Corners;
using by_hand::edge_function;
using by_hand::snapped;

TEST_CASE("18 positions are snapped to the nearest, ties to even") {
    CHECK(snapped(2.5F, 0) == 512);
    CHECK(snapped(3.5F, 0) == 1024);
    CHECK(snapped(-0.6F, 0) == -256);
    CHECK(snapped(0.53F, 4) == 128);
    CHECK(snapped(-0.54F, 4) == -144);
    CHECK(snapped(1.0F / 512, 8) == 0);
    CHECK(snapped(3.0F / 512, 8) == 2);
    CHECK(snapped(-16384, 0) == -4194304);
    for (int i = -3000; i <= 3000; ++i) {
        CHECK(snapped(static_cast<float>(i) * 0.0137F, 8) == snap(static_cast<float>(i) * 0.0137F));
    }
}

TEST_CASE("18 an edge function is 0 on the edge and twice an area beside it") {
    const glm::ivec2 p(-4194304, 4194304);
    const glm::ivec2 q(4194303, -4194301);
    const auto e = edge_function(p, q);
    CHECK(e.at(p.x, p.y) == 0);
    CHECK(e.at(q.x, q.y) == 0);
    CHECK(edge_function({0, 0}, {10, 0}).at(3, 7) == 70);  // below: on the right of +x
    CHECK(edge_function({10, 0}, {0, 0}).at(3, 7) == -70);
}

using Covered = std::vector<std::pair<int, int>>;

template <class I>
Covered covered(const Corners& corners) {
    Covered all;
    by_hand::cover<I>(corners, 8, 8, [&](int x, int y) { all.emplace_back(x, y); });
    return all;
}

TEST_CASE_TEMPLATE("18 centres on edges belong to left and top", I, std::int32_t, Int<4>,
                   IntOf<Float8>, IntOf<Float16>) {
    // Corners on the centres of pixels 1, 1 and 3, 3: of a square, both halves.
    const glm::ivec2 a(384, 384);
    const glm::ivec2 b(896, 384);
    const glm::ivec2 c(896, 896);
    const glm::ivec2 d(384, 896);
    CHECK(covered<I>({a, b, c}) == Covered{{1, 1}, {2, 1}, {2, 2}});
    CHECK(covered<I>({a, c, b}) == covered<I>({a, b, c}));
    CHECK(covered<I>({c, d, a}) == Covered{{1, 2}});
    CHECK(covered<I>({a, b, a}).empty());
    CHECK(covered<I>({a, c, {640, 640}}).empty());  // on one line
    CHECK(covered<I>({a, a, a}).empty());
}

// The lesson's text as the oracle takes it; it samples centres alone, so the triangles are moved.
template <class I>
void by_lesson(std::span<const oracle::Triangle> triangles, int width, int height, int samples,
               const oracle::Emit& emit) {
    const auto positions = oracle::sample_positions(samples);
    for (int s = 0; s < samples; ++s) {
        const auto [dx, dy] = positions[static_cast<std::size_t>(s)];
        for (std::size_t t = 0; t < triangles.size(); ++t) {
            Corners corners;
            for (std::size_t i = 0; i < 3; ++i) {
                corners[i] = {triangles[t][i].x + 128 - dx, triangles[t][i].y + 128 - dy};
            }
            by_hand::cover<I>(corners, width, height,
                              [&](int x, int y) { emit(s, static_cast<int>(t), y, x, x + 1); });
        }
    }
}

TEST_CASE_TEMPLATE("18 coverage is exact", I, std::int32_t, Int<4>, IntOf<Float8>, IntOf<Float16>) {
    const oracle::Verdict verdict = oracle::check_all(by_lesson<I>, 4000);
    INFO(verdict.report);
    CHECK(verdict.failures == 0);
}

// ---- the README's table
// --------------------------------------------------------------------------

// Which triangle has pixel x, y of a grid; -1 where two have it.
using Owners = std::map<std::tuple<std::string, int, int>, int>;

Owners owners(int bits) {
    Owners all;
    for (const grids::Grid& grid : grids::all()) {
        int index = 0;
        for (const auto& triangle : grid.triangles) {
            Corners corners;
            for (std::size_t i = 0; i < 3; ++i) {
                corners[i] = {snapped(triangle[i].x, bits), snapped(triangle[i].y, bits)};
            }
            by_hand::cover<std::int32_t>(corners, grids::width, grids::height, [&](int x, int y) {
                const bool first = all.emplace(std::tuple(grid.name, x, y), index).second;
                CHECK(first);
            });
            ++index;
        }
    }
    return all;
}

int differing(const Owners& a, const Owners& b) {
    int same = 0;
    int both = 0;
    for (const auto& [pixel, owner] : a) {
        const auto other = b.find(pixel);
        both += other != b.end() ? 1 : 0;
        same += other != b.end() && other->second == owner ? 1 : 0;
    }
    return static_cast<int>(a.size() + b.size()) - both - same;
}

TEST_CASE("18 fewer bits give pixels to other triangles, but each to one") {
    const Owners finest = owners(8);
    CHECK(finest.size() == 544);
    CHECK(owners(4).size() == 546);
    CHECK(owners(0).size() == 546);
    CHECK(differing(owners(4), finest) == 12);
    CHECK(differing(owners(0), finest) == 137);
}

}  // namespace
}  // namespace glint
