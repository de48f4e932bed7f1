#include "framework/image/flip.hpp"

#include "framework/image/colour.hpp"
#include "framework/image/flip_parts.hpp"
#include "framework/image/same_size.hpp"
#include "framework/image/srgb.hpp"

#include <algorithm>

namespace glint {
namespace {

flip::Opponent opponent_planes(const SrgbImage& image) {
    const flip::Plane plane(image.width(), image.height());
    flip::Opponent planes{plane, plane, plane};
    for (std::size_t i = 0; i < image.pixels().size(); ++i) {
        const Rgba8 p = image.pixels()[i];
        const Rgb<float> rgb(srgb_to_linear(p.r), srgb_to_linear(p.g), srgb_to_linear(p.b));
        const glm::vec3 ycxcz = opponent(xyz_from_rgb(rgb));
        planes[0].pixels()[i] = ycxcz.x;
        planes[1].pixels()[i] = ycxcz.y;
        planes[2].pixels()[i] = ycxcz.z;
    }
    return planes;
}

}  // namespace

Image<float> flip_map(const SrgbImage& reference, const SrgbImage& test, float pixels_per_degree) {
    require_same_size(reference, test);
    const flip::Opponent a = opponent_planes(reference);
    const flip::Opponent b = opponent_planes(test);
    Image<float> map = flip::colour_difference(a, b, pixels_per_degree);
    const Image<float> features = flip::feature_difference(a[0], b[0], pixels_per_degree);
    std::ranges::transform(map.pixels(), features.pixels(), map.pixels().begin(),
                           [](float colour, float feature) {
                               // The final difference: features make one of colour count more.
                               return std::pow(colour, std::max(1.0F - feature, 0.0F));
                           });
    return map;
}

}  // namespace glint
