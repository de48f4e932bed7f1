#include "docs/charts/net.hpp"

#include "tests/oracle/coverage_oracle.hpp"
#include "tests/oracle/random.hpp"

#include <glm/common.hpp>

#include <algorithm>

namespace glint::charts {
namespace {

constexpr double finest = 0x1p-14;  // of a pixel: what the oracle is asked in

oracle::Point fixed(const glm::dvec2& p) {
    return {static_cast<std::int32_t>(p.x / finest), static_cast<std::int32_t>(p.y / finest)};
}

// The pixel of the window that holds a place, or else the nearest.
glm::ivec2 in_window(const glm::dvec2& place) {
    return {clamp(floor(place), glm::dvec2(0), glm::dvec2(net_window - 1))};
}

}  // namespace

Net net_of(double pixels) {
    oracle::Random random(1);
    const int cells = static_cast<int>((net_window + 4) / pixels) + 1;
    Net net;
    for (int row = 0; row <= cells; ++row) {
        for (int column = 0; column <= cells; ++column) {
            const double x = column + random.real(-0.2, 0.2);  // more could fold it
            const double y = row + random.real(-0.2, 0.2);
            net.knots.push_back(glm::round((glm::dvec2(x, y) * pixels - 2.0) / finest) * finest);
            if (row < cells && column < cells) {
                const auto a = static_cast<std::uint32_t>(row * (cells + 1) + column);
                const auto below = a + static_cast<std::uint32_t>(cells) + 1;
                net.triangles.emplace_back(a, below, a + 1);
                net.triangles.emplace_back(a + 1, below, below + 1);
            }
        }
    }
    return net;
}

Image<std::int32_t> exact_owners(const Net& net) {
    Image<std::int32_t> owner(net_window, net_window, -1);
    for (std::size_t t = 0; t < net.triangles.size(); ++t) {
        const glm::uvec3 i = net.triangles[t];
        const glm::dvec2 corner[] = {net.knots[i.x], net.knots[i.y], net.knots[i.z]};
        const oracle::Triangle triangle{fixed(corner[0]), fixed(corner[1]), fixed(corner[2])};
        const glm::ivec2 first = in_window(min(min(corner[0], corner[1]), corner[2]));
        const glm::ivec2 last = in_window(max(max(corner[0], corner[1]), corner[2]));
        for (int y = first.y; y <= last.y; ++y) {
            for (int x = first.x; x <= last.x; ++x) {
                if (oracle::covers(triangle, fixed({x + 0.5, y + 0.5}))) {
                    owner(x, y) = static_cast<std::int32_t>(t);
                }
            }
        }
    }
    return owner;
}

}  // namespace glint::charts
