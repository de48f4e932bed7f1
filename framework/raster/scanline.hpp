// The scanline rasterizer: triangles are walked row by row between two edges, as in a lecture.
#pragma once

#include "framework/raster/pipeline.hpp"
#include "framework/raster/samples.hpp"
#include "framework/raster/setup.hpp"

#include <algorithm>
#include <cstdint>
#include <utility>

namespace glint {

// Ceiling of a / b for b > 0.
constexpr std::int64_t ceil_div(std::int64_t a, std::int64_t b) {
    return a / b + (a % b > 0 ? 1 : 0);
}

// The first row or column whose sample lies at or beyond a position; both in 1/256 pixel.
constexpr std::int64_t first_sample(std::int64_t position, int offset) {
    return ceil_div(position - subpixel_one / 2 - offset, subpixel_one);
}

// Walks an edge down the rows of samples. On each row it stands on the first column whose sample
// lies at or to the right of the edge. That column is the ceiling of a fraction; a step to the next
// row adds dx/dy to it exactly, as a whole part and a remainder (Bresenham 1965).
class EdgeWalker {
  public:
    // From (x0, y0) down to (x1, y1), y0 < y1, starting on row.
    EdgeWalker(std::int64_t x0, std::int64_t y0, std::int64_t x1, std::int64_t y1, std::int64_t row,
               SampleOffset offset)
        : denominator_(subpixel_one * (y1 - y0)) {
        const std::int64_t sample_y = subpixel_one * row + subpixel_one / 2 + offset.y;
        const std::int64_t numerator =
            (x0 - subpixel_one / 2 - offset.x) * (y1 - y0) + (sample_y - y0) * (x1 - x0);
        column_ = ceil_div(numerator, denominator_);
        ahead_ = column_ * denominator_ - numerator;
        const std::int64_t step = subpixel_one * (x1 - x0);
        whole_ = ceil_div(step, denominator_);
        rest_ = whole_ * denominator_ - step;
    }

    std::int64_t column() const { return column_; }

    void next_row() {
        column_ += whole_;
        ahead_ += rest_;
        if (ahead_ >= denominator_) {
            ahead_ -= denominator_;
            --column_;
        }
    }

  private:
    std::int64_t denominator_;
    std::int64_t column_;
    std::int64_t ahead_;  // how far column_ is beyond the edge, in 1/denominator_; 0 <= it < 1
    std::int64_t whole_;  // a row's step, rounded up ...
    std::int64_t rest_;   // ... by this much
};

// Calls span(row, first, last) for each row of samples that the triangle covers: columns
// first <= column < last. Samples on a left or top edge are in, on a right or bottom edge out.
template <class Span>
void walk_triangle(const ScreenVertex (&v)[3], SampleOffset offset, int width, int height,
                   Span&& span) {
    const ScreenVertex* top = &v[0];
    const ScreenVertex* middle = &v[1];
    const ScreenVertex* bottom = &v[2];
    const auto lower = [](const ScreenVertex* a, const ScreenVertex* b) { return a->y > b->y; };
    if (lower(top, middle)) {
        std::swap(top, middle);
    }
    if (lower(middle, bottom)) {
        std::swap(middle, bottom);
    }
    if (lower(top, middle)) {
        std::swap(top, middle);
    }
    const auto rows = [&](const ScreenVertex* from, const ScreenVertex* to, const bool bends_left) {
        const std::int64_t first = std::max<std::int64_t>(first_sample(from->y, offset.y), 0);
        const std::int64_t last = std::min<std::int64_t>(first_sample(to->y, offset.y), height);
        if (first >= last) {
            return;
        }
        EdgeWalker left(top->x, top->y, bottom->x, bottom->y, first, offset);  // the long edge
        EdgeWalker right(from->x, from->y, to->x, to->y, first, offset);
        if (bends_left) {
            std::swap(left, right);
        }
        for (std::int64_t row = first; row < last; ++row, left.next_row(), right.next_row()) {
            const std::int64_t begin = std::max<std::int64_t>(left.column(), 0);
            const std::int64_t end = std::min<std::int64_t>(right.column(), width);
            if (begin < end) {
                span(static_cast<int>(row), static_cast<int>(begin), static_cast<int>(end));
            }
        }
    };
    const ScreenVertex sorted[3] = {*top, *middle, *bottom};
    const std::int64_t side = edges_of(sorted).double_area;  // positive: middle is on the right
    if (side != 0) {
        rows(top, middle, side < 0);
        rows(middle, bottom, side < 0);
    }
}

}  // namespace glint
