#include "tests/oracle/coverage_oracle.hpp"

#include <algorithm>
#include <stdexcept>

namespace glint::oracle {
namespace {

constexpr std::int64_t divide_up(std::int64_t a, std::int64_t b) {  // ceil(a / b) for b > 0
    return a / b + (a % b > 0 ? 1 : 0);
}

constexpr Point from_centre(int x, int y) {  // in 1/16 px
    return {128 + 16 * x, 128 + 16 * y};
}

constexpr std::array one{from_centre(0, 0)};
constexpr std::array two{from_centre(4, 4), from_centre(-4, -4)};
constexpr std::array four{from_centre(-2, -6), from_centre(6, -2), from_centre(-6, 2),
                          from_centre(2, 6)};
constexpr std::array eight{from_centre(1, -3),  from_centre(-1, 3), from_centre(5, 1),
                           from_centre(-3, -5), from_centre(-5, 5), from_centre(-7, -1),
                           from_centre(3, 7),   from_centre(7, -7)};
constexpr std::array sixteen{
    from_centre(1, 1),   from_centre(-1, -3), from_centre(-3, 2),  from_centre(4, -1),
    from_centre(-5, -2), from_centre(2, 5),   from_centre(5, 3),   from_centre(3, -5),
    from_centre(-2, 6),  from_centre(0, -7),  from_centre(-4, -6), from_centre(-6, 4),
    from_centre(-8, 0),  from_centre(7, -4),  from_centre(6, 7),   from_centre(-7, -8)};

bool is_top_or_left(Point a, Point b, Point interior) {
    if (a.y == b.y) {
        return interior.y > a.y;
    }
    const Point& upper = a.y < b.y ? a : b;
    const Point& lower = a.y < b.y ? b : a;
    return doubled_area(upper, lower, interior) < 0;  // going down, the interior is to the right
}

bool is_on_inner_side(Point a, Point b, Point interior, Point sample) {
    const std::int64_t side = doubled_area(a, b, sample);
    if (side == 0) {
        return is_top_or_left(a, b, interior);
    }
    return (side > 0) == (doubled_area(a, b, interior) > 0);
}

// The first pixel whose sample is on or right of the edge, in a row of samples that it crosses.
int first_pixel_right_of(Point upper, Point lower, Point row_start) {
    const std::int64_t dx = std::int64_t{lower.x} - upper.x;
    const std::int64_t dy = std::int64_t{lower.y} - upper.y;
    const std::int64_t x =
        (std::int64_t{upper.x} - row_start.x) * dy + (std::int64_t{row_start.y} - upper.y) * dx;
    return static_cast<int>(divide_up(x, units_per_pixel * dy));
}

void find_crossings(std::span<const Point> polygon, Point row_start, std::vector<int>& crossings) {
    crossings.clear();
    Point a = polygon.back();
    for (const Point b : polygon) {
        const Point& upper = a.y < b.y ? a : b;
        const Point& lower = a.y < b.y ? b : a;
        if (upper.y <= row_start.y && row_start.y < lower.y) {
            crossings.push_back(first_pixel_right_of(upper, lower, row_start));
        }
        a = b;
    }
    std::sort(crossings.begin(), crossings.end());
}

}  // namespace

std::int64_t doubled_area(Point a, Point b, Point c) {
    const std::int64_t abx = std::int64_t{b.x} - a.x;
    const std::int64_t aby = std::int64_t{b.y} - a.y;
    const std::int64_t acx = std::int64_t{c.x} - a.x;
    const std::int64_t acy = std::int64_t{c.y} - a.y;
    return abx * acy - aby * acx;
}

bool covers(const Triangle& triangle, Point sample) {
    const auto& [a, b, c] = triangle;
    return doubled_area(a, b, c) != 0 && is_on_inner_side(a, b, c, sample) &&
           is_on_inner_side(b, c, a, sample) && is_on_inner_side(c, a, b, sample);
}

std::span<const Point> sample_positions(int samples) {
    switch (samples) {
        case 1:
            return one;
        case 2:
            return two;
        case 4:
            return four;
        case 8:
            return eight;
        case 16:
            return sixteen;
        default:
            throw std::invalid_argument("samples per pixel are 1, 2, 4, 8 or 16");
    }
}

void append_runs(std::span<const Point> polygon, Point position, int width, int height,
                 std::vector<Run>& runs) {
    const auto [top, bottom] = std::minmax_element(
        polygon.begin(), polygon.end(), [](const Point& a, const Point& b) { return a.y < b.y; });
    const auto first_row_at = [&](std::int64_t y) {
        const std::int64_t row = divide_up(y - position.y, units_per_pixel);
        return static_cast<int>(std::clamp<std::int64_t>(row, 0, height));
    };
    const int end = first_row_at(bottom->y);
    std::vector<int> crossings;
    for (int y = first_row_at(top->y); y < end; ++y) {
        find_crossings(polygon, {position.x, position.y + y * units_per_pixel}, crossings);
        const std::size_t row_begin = runs.size();
        for (std::size_t i = 0; i + 1 < crossings.size(); i += 2) {
            const int x_begin = std::max(crossings[i], 0);
            const int x_end = std::min(crossings[i + 1], width);
            if (x_begin >= x_end) {
                continue;
            }
            if (runs.size() > row_begin && runs.back().x_end == x_begin) {
                runs.back().x_end = x_end;
            } else {
                runs.push_back({y, x_begin, x_end});
            }
        }
    }
}

}  // namespace glint::oracle
