#include "tests/oracle/cases.hpp"

#include <algorithm>
#include <cmath>

namespace glint::oracle {
namespace {

void choose_viewport(Random& random, Case& c) {
    const bool large = random.one_in(300);
    c.width = large ? random.between(97, 4096) : random.between(16, 96);
    c.height = large ? random.between(97, 2304) : random.between(16, 96);
    c.samples = random.one_in(2) ? 1 : 1 << random.between(1, 4);
}

void reorder_vertices(Random& random, Triangle& t) {
    std::rotate(t.begin(), t.begin() + random.between(0, 2), t.end());
    if (random.one_in(2)) {
        std::swap(t[0], t[1]);
    }
}

// One in three is the first or the last of a block of 8, 16, ... pixels: tiles are decided there.
int any_pixel(Random& random, int size) {
    const int any = random.between(0, size - 1);
    return random.one_in(3) ? std::clamp(any / 8 * 8 - random.between(0, 1), 0, size - 1) : any;
}

}  // namespace

std::vector<Kind> all_kinds() {
    std::vector<Kind> kinds(triangle_kinds().begin(), triangle_kinds().end());
    kinds.insert(kinds.end(), mesh_kinds().begin(), mesh_kinds().end());
    return kinds;
}

Case make_case(const Kind& kind, std::uint64_t seed) {
    Random random(seed);
    Case c;
    c.kind = kind.name;
    c.seed = seed;
    choose_viewport(random, c);
    do {
        c.triangles.clear();
        c.outline.clear();
        kind.draw(random, c);
    } while (!c.outline.empty() && is_folded(c.triangles));  // rounding may fold thin cells
    for (Triangle& t : c.triangles) {
        reorder_vertices(random, t);
    }
    return c;
}

bool is_folded(std::span<const Triangle> mesh) {
    bool clockwise = false;
    bool counter_clockwise = false;
    for (const auto& [a, b, d] : mesh) {
        clockwise |= doubled_area(a, b, d) > 0;
        counter_clockwise |= doubled_area(a, b, d) < 0;
    }
    return clockwise && counter_clockwise;
}

Point from_pixels(double x, double y) {
    const auto unit = [](double pixels) {
        const double units = std::nearbyint(pixels * units_per_pixel);
        return static_cast<std::int32_t>(
            std::clamp(units, double{-guard_band}, double{guard_band}));
    };
    return {unit(x), unit(y)};
}

Point anywhere(Random& random, const Case& c, int margin_in_pixels) {
    const int margin = margin_in_pixels * units_per_pixel;
    return {random.between(-margin, c.width * units_per_pixel + margin),
            random.between(-margin, c.height * units_per_pixel + margin)};
}

Point any_sample(Random& random, const Case& c) {
    const auto positions = sample_positions(c.samples);
    const Point position = positions[static_cast<std::size_t>(random.between(0, c.samples - 1))];
    return {any_pixel(random, c.width) * units_per_pixel + position.x,
            any_pixel(random, c.height) * units_per_pixel + position.y};
}

Point any_corner(Random& random, const Case& c) {
    return {random.between(0, c.width) * units_per_pixel,
            random.between(0, c.height) * units_per_pixel};
}

}  // namespace glint::oracle
