// What the program coverage reads and writes: triangles in, the pixels that they cover out.
//
// Input, a triangle a line, positions in pixels (origin top-left, y down):
//     T id width height x0 y0 x1 y1 x2 y2
// Consecutive lines with the same id are a mesh and share width and height. Blank lines and lines
// that start with # are passed over.
//
// Output, for each case, rows from the top, each from the left, x_end not included:
//     T id
//     y x_begin x_end            for a single triangle
//     y x_begin x_end index      for a mesh; index counts its triangles from 0
#pragma once

#include "framework/math/fixed.hpp"
#include "framework/math/vec.hpp"

#include <array>
#include <iosfwd>
#include <optional>
#include <string>
#include <vector>

namespace glint {

struct CoverageCase {
    std::string id;  // one word
    int width = 0;   // 1..16384 pixels
    int height = 0;  // 1..16384 pixels

    // In 1/256 pixel, snapped to nearest, ties to even; within +-16384 pixels. A triangle may wind
    // either way and may have no area.
    std::vector<std::array<glm::ivec2, 3>> triangles;
};

struct CoverageRun {  // pixels x_begin <= x < x_end of row y
    int triangle, y, x_begin, x_end;
};

// How a stream is read, and how far it is.
struct CoverageInput {
    int bits = subpixel_bits;  // 0..8: positions are snapped to 1/2^bits pixel
    int line = 0;
    std::optional<CoverageCase> begun;
    std::string text;
};

// The next case, as soon as a line of another or the end shows that it is complete; nothing at the
// end. Error "standard input:LINE: ..." where a line is not as above.
std::optional<CoverageCase> read_case(std::istream& in, CoverageInput& state);

// Writes and flushes one case. The runs may come in any order and in pieces that touch. Error if
// the stream takes no more.
void write_case(std::ostream& out, const CoverageCase& c, std::vector<CoverageRun> runs);

}  // namespace glint
