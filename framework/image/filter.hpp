// Filters of pictures with one channel, along the rows or along the columns.
#pragma once

#include "framework/image/image.hpp"

#include <algorithm>

namespace glint {

// What lies beyond the edge of a row abc: aa abc cc, or ba abc cb.
enum class Border { repeat, mirror };

// The index in 0..size-1 whose value stands for index i, which may be any.
inline int inside(int i, int size, Border border) {
    if (border == Border::repeat) {
        return std::clamp(i, 0, size - 1);
    }
    const int period = 2 * size;
    const int phase = ((i % period) + period) % period;
    return std::min(phase, period - 1 - phase);
}

// Adds weight times each value of row: the loop that nearly all the time goes to.
template <class T>
void add_weighted(std::span<T> sum, T weight, const T* row) {
    for (std::size_t x = 0; x < sum.size(); ++x) {
        sum[x] += weight * row[x];
    }
}

// Each pixel becomes the weighted sum of its row's neighbours; the middle one of the 2r+1 weights
// is its own.
template <class T>
Image<T> filter_rows(const Image<T>& in, const std::vector<T>& weights, Border border) {
    const int radius = static_cast<int>(weights.size()) / 2;
    Image<T> out(in.width(), in.height());
    std::vector<T> padded(static_cast<std::size_t>(in.width()) + weights.size());
    for (int y = 0; y < in.height(); ++y) {
        auto to = padded.begin();
        for (int x = -radius; x < in.width() + radius; ++x) {
            *to++ = in(inside(x, in.width(), border), y);
        }
        for (std::size_t i = 0; i < weights.size(); ++i) {
            add_weighted(out.row(y), weights[i], &padded[i]);
        }
    }
    return out;
}

// The same along the columns.
template <class T>
Image<T> filter_columns(const Image<T>& in, const std::vector<T>& weights, Border border) {
    const int radius = static_cast<int>(weights.size()) / 2;
    Image<T> out(in.width(), in.height());
    for (int y = 0; y < in.height(); ++y) {
        for (std::size_t i = 0; i < weights.size(); ++i) {
            const int from = inside(y + static_cast<int>(i) - radius, in.height(), border);
            add_weighted(out.row(y), weights[i], in.row(from).data());
        }
    }
    return out;
}

}  // namespace glint
