#include "tests/oracle/cases.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <utility>

namespace glint::oracle {
namespace {

Point operator+(Point a, Point b) {
    return {a.x + b.x, a.y + b.y};
}
Point operator-(Point a, Point b) {
    return {a.x - b.x, a.y - b.y};
}
Point operator*(int n, Point a) {
    return {n * a.x, n * a.y};
}

Point step(Random& random, int units) {
    return {random.between(-units, units), random.between(-units, units)};
}

void draw_small(Random& random, Case& c) {
    const Point p = anywhere(random, c, 8);
    const int size = random.between(1, 8) * units_per_pixel;
    c.triangles = {{p + step(random, size), p + step(random, size), p + step(random, size)}};
}

void draw_large(Random& random, Case& c) {
    const int margin = 2 * std::max(c.width, c.height);
    c.triangles = {
        {anywhere(random, c, margin), anywhere(random, c, margin), anywhere(random, c, margin)}};
}

// As thin as a triangle gets: the third vertex is one unit beside the line between the others.
void draw_sliver(Random& random, Case& c) {
    const Point a = anywhere(random, c, 0);
    const double angle = random.real(0, 2 * std::numbers::pi);
    const double length = std::exp(random.real(std::log(1.0), std::log(8000.0)));
    const Point along = from_pixels(length * std::cos(angle), length * std::sin(angle));
    const int there = random.between(-256, 0);  // the line's start, in 1/256 of its length
    const int between = random.between(there, there + 256);
    const auto on_line = [&](int n) {
        return from_pixels((a.x + n / 256.0 * along.x) / units_per_pixel,
                           (a.y + n / 256.0 * along.y) / units_per_pixel);
    };
    c.triangles = {{on_line(there), on_line(there + 256), on_line(between) + step(random, 1)}};
}

void draw_zero_area(Random& random, Case& c) {
    const Point a = random.one_in(2) ? any_sample(random, c) : anywhere(random, c, 8);
    Point d = step(random, 1 << random.between(1, 12));
    if (random.one_in(4)) {
        (random.one_in(2) ? d.x : d.y) = 0;
    }
    // Equal multiples repeat a vertex.
    const auto collinear = [&] { return a + random.between(-4, 4) * d; };
    c.triangles = {{collinear(), collinear(), collinear()}};
}

void draw_sub_pixel(Random& random, Case& c) {
    const Point p = random.one_in(2) ? any_sample(random, c) : anywhere(random, c, 1);
    const int size = random.between(1, units_per_pixel / 2);
    c.triangles = {{p + step(random, size), p + step(random, size), p + step(random, size)}};
}

void draw_on_samples(Random& random, Case& c) {
    c.triangles = {{any_sample(random, c), any_sample(random, c), any_sample(random, c)}};
}

void draw_on_corners(Random& random, Case& c) {
    c.triangles = {{any_corner(random, c), any_corner(random, c), any_corner(random, c)}};
}

// One edge is horizontal, another vertical, or near it by a unit; half of them meet samples.
void draw_axis_aligned(Random& random, Case& c) {
    const Point corner = random.one_in(2) ? any_sample(random, c) : any_corner(random, c);
    const Point far = random.one_in(2) ? any_sample(random, c) : anywhere(random, c, 200);
    Triangle t{corner, {far.x, corner.y}, {corner.x, far.y}};
    if (random.one_in(4)) {
        t[1] = t[1] + step(random, 1);
    }
    if (random.one_in(4)) {
        t[2] = anywhere(random, c, 8);
    }
    c.triangles = {t};
}

// An edge of any slope meets a sample exactly, most of them many samples.
void draw_through_samples(Random& random, Case& c) {
    const Point sample = any_sample(random, c);
    Point d = step(random, 1 << random.between(0, 10));
    if (random.one_in(2)) {
        d = units_per_pixel * step(random, 5);  // from each pixel to the same place of another
    }
    const Point a = sample - random.between(0, 10) * d;
    const Point b = sample + random.between(0, 10) * d;
    c.triangles = {{a, b, random.one_in(2) ? any_sample(random, c) : anywhere(random, c, 8)}};
}

// With u.x d.y - u.y d.x = -1: the point u is as near to the line along d as a point can be.
// For coprime positive d, by Euclid's algorithm.
Point nearest_to_line(Point d) {
    int s = 1;
    int next_s = 0;
    int r = d.x;
    int next_r = d.y;
    while (next_r != 0) {
        const int quotient = r / next_r;
        s = std::exchange(next_s, s - quotient * next_s);
        r = std::exchange(next_r, r - quotient * next_r);
    }
    // s d.x = 1 modulo d.y
    const std::int64_t y = s > 0 ? s : std::int64_t{s} + d.y;
    return {static_cast<int>((y * d.x - 1) / d.y), static_cast<int>(y)};
}

// An edge misses a sample by the least area there is: an error of one unit shows.
void draw_near_misses(Random& random, Case& c) {
    const int longest = 1 << random.between(3, 21);
    Point d{};
    do {
        d = {random.between(1, longest), random.between(1, longest)};
    } while (std::gcd(d.x, d.y) != 1);
    Point u = nearest_to_line(d);
    if (random.one_in(2)) {
        d.x = -d.x;
        u.x = -u.x;
    }
    if (random.one_in(2)) {
        u = d - u;  // the same from the other end, on the other side
    }
    const Point a = any_sample(random, c) - u;
    c.triangles = {{a, a + d, anywhere(random, c, random.one_in(2) ? 8 : 4000)}};
}

void draw_across_guard_band(Random& random, Case& c) {
    const auto far = [&]() -> Point {
        const int side = random.one_in(2) ? guard_band : -guard_band;
        const int other = random.one_in(4) ? guard_band : random.between(-guard_band, guard_band);
        return random.one_in(2) ? Point{side, other} : Point{other, side};
    };
    const auto near = [&] { return anywhere(random, c, 100); };
    c.triangles = {{far(), random.one_in(3) ? near() : far(), random.one_in(3) ? near() : far()}};
}

void draw_beyond_viewport(Random& random, Case& c) {
    const int distance = random.one_in(2) ? units_per_pixel : guard_band / 4;
    const int side = random.between(0, 3);
    const auto beyond = [&]() -> Point {
        const Point p = anywhere(random, c, 2000);
        const int outwards = random.between(0, distance);
        switch (side) {
            case 0:
                return {-outwards, p.y};
            case 1:
                return {p.x, -outwards};
            case 2:
                return {c.width * units_per_pixel + outwards, p.y};
            default:
                return {p.x, c.height * units_per_pixel + outwards};
        }
    };
    c.triangles = {{beyond(), beyond(), beyond()}};
}

// The long side clears the viewport's last corner, or runs along the last pixel's centre.
void draw_over_viewport(Random& random, Case& c) {
    const Point outside{random.between(0, 1000 * units_per_pixel),
                        random.between(0, 1000 * units_per_pixel)};
    const int w = c.width * units_per_pixel;
    const int h = c.height * units_per_pixel;
    const int spare =
        random.one_in(2) ? random.between(-1, 1) - units_per_pixel : random.between(0, 1 << 20);
    const int leg = w + h + outside.x + outside.y + spare;
    Triangle t{Point{-outside.x, -outside.y}, Point{leg - outside.x, -outside.y},
               Point{-outside.x, leg - outside.y}};
    const bool mirror_x = random.one_in(2);
    const bool mirror_y = random.one_in(2);
    for (Point& p : t) {
        p = {mirror_x ? w - p.x : p.x, mirror_y ? h - p.y : p.y};
    }
    c.triangles = {t};
}

constexpr Kind kinds[] = {
    {"small triangles", draw_small},
    {"large triangles", draw_large},
    {"slivers", draw_sliver},
    {"zero area", draw_zero_area},
    {"sub-pixel triangles", draw_sub_pixel},
    {"vertices on samples", draw_on_samples},
    {"vertices on pixel corners", draw_on_corners},
    {"horizontal and vertical edges", draw_axis_aligned},
    {"edges through samples", draw_through_samples},
    {"edges that just miss samples", draw_near_misses},
    {"across the guard band", draw_across_guard_band},
    {"beyond the viewport", draw_beyond_viewport},
    {"over the whole viewport", draw_over_viewport},
};

}  // namespace

std::span<const Kind> triangle_kinds() {
    return kinds;
}

}  // namespace glint::oracle
