// Triangles and meshes to try a rasterizer with, from seeds: each kind is made to hurt in its way.
#pragma once

#include "tests/oracle/coverage_oracle.hpp"
#include "tests/oracle/random.hpp"

#include <string_view>

namespace glint::oracle {

struct Case {
    std::string_view kind;
    std::uint64_t seed = 0;
    int width = 0;
    int height = 0;
    int samples = 1;  // a pixel: 1, 2, 4, 8 or 16
    std::vector<Triangle> triangles;

    // Of a mesh: its border. Exactly one triangle covers each sample inside, none any other.
    // A hole is tied to the outside by an edge that goes there and back. Empty for no mesh.
    std::vector<Point> outline;
};

struct Kind {
    std::string_view name;
    void (*draw)(Random&, Case&);  // adds the triangles to a case that has its viewport
};

std::span<const Kind> triangle_kinds();  // one triangle a case
std::span<const Kind> mesh_kinds();      // up to 300 triangles a case, without overlap
std::vector<Kind> all_kinds();

// The same kind and seed make the same case: most of 16 to 96 pixels a side, a few of thousands.
Case make_case(const Kind& kind, std::uint64_t seed);

// Two triangles of a mesh wind in opposite ways: it overlaps itself. Zero area winds neither way.
bool is_folded(std::span<const Triangle> mesh);

// Places in and around a case's viewport.
Point from_pixels(double x, double y);  // rounded to units, drawn back to the guard band
Point anywhere(Random& random, const Case& c, int margin_in_pixels);
Point any_sample(Random& random, const Case& c);
Point any_corner(Random& random, const Case& c);  // where four pixels meet

}  // namespace glint::oracle
