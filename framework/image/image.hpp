// A picture: rows of pixels from the top, each row from the left.
#pragma once

#include "framework/math/memory.hpp"
#include "framework/math/vec.hpp"

#include <cstddef>
#include <cstdint>
#include <span>

namespace glint {

struct Rgba8 {  // code values of IEC 61966-2-1 (sRGB); alpha is opacity, linear
    std::uint8_t r, g, b, a;
    friend bool operator==(const Rgba8&, const Rgba8&) = default;
};

template <class Pixel>
class Image {
  public:
    Image() = default;
    Image(int width, int height, const Pixel& fill = {})
        : width_(width),
          height_(height),
          pixels_(static_cast<std::size_t>(width) * static_cast<std::size_t>(height), fill) {}

    int width() const { return width_; }
    int height() const { return height_; }
    bool empty() const { return pixels_.empty(); }

    // 0 <= x < width(), 0 <= y < height(), not checked.
    Pixel& operator()(int x, int y) { return row(y)[static_cast<std::size_t>(x)]; }
    const Pixel& operator()(int x, int y) const { return row(y)[static_cast<std::size_t>(x)]; }

    std::span<Pixel> row(int y) {
        return pixels().subspan(offset(y), static_cast<std::size_t>(width_));
    }
    std::span<const Pixel> row(int y) const {
        return pixels().subspan(offset(y), static_cast<std::size_t>(width_));
    }
    std::span<Pixel> pixels() { return pixels_; }
    std::span<const Pixel> pixels() const { return pixels_; }

    friend bool operator==(const Image&, const Image&) = default;

  private:
    std::size_t offset(int y) const {
        return static_cast<std::size_t>(y) * static_cast<std::size_t>(width_);
    }
    int width_ = 0;
    int height_ = 0;
    LineVector<Pixel> pixels_;
};

using LinearImage = Image<Rgb<float>>;  // radiance, unclamped
using SrgbImage = Image<Rgba8>;         // what a screen shows

}  // namespace glint
