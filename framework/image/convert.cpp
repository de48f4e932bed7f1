#include "framework/image/convert.hpp"

#include "framework/image/srgb.hpp"

#include <algorithm>

namespace glint {

SrgbImage to_srgb(const LinearImage& image) {
    SrgbImage out(image.width(), image.height());
    std::ranges::transform(image.pixels(), out.pixels().begin(), [](const Rgb<float>& p) {
        return Rgba8{linear_to_srgb(p.r), linear_to_srgb(p.g), linear_to_srgb(p.b), 255};
    });
    return out;
}

LinearImage to_linear(const SrgbImage& image) {
    LinearImage out(image.width(), image.height());
    std::ranges::transform(image.pixels(), out.pixels().begin(), [](const Rgba8& p) {
        return Rgb<float>(srgb_to_linear(p.r), srgb_to_linear(p.g), srgb_to_linear(p.b));
    });
    return out;
}

}  // namespace glint
