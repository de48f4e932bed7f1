// What must hold of every picture and of every material, whatever the world.
#pragma once

#include "lessons/04_rendering_equation/rendering_equation.hpp"
#include "framework/raster/plug.hpp"
#include "tests/stability/property_world.hpp"

#include <functional>
#include <span>
#include <string>

namespace glint::stability {

// Draws with both rasterizers, in all lanes and with several threads; shaders[i] for surfaces[i].
// Says what is wrong, or nothing:
//   - a radiance that is no number, is negative, or is above what the BRDF's largest value makes of
//     the light that arrives (stated_brightest());
//   - another triangle or depth in a pixel than the scanlines have, or a colour that differs by
//     more than the rounding of its varyings explains;
//   - a bit that depends on the number of threads.
std::string picture_fault(const World& world, std::span<const Shader> shaders);

// The same of the world's model, or of a BRDF that make(surface) gives in its place.
template <class Make>
std::string picture_fault_with(const World& world, Make make) {
    using Brdf = decltype(make(world.surfaces[0]));
    std::vector<Lit<Brdf>> lit;
    lit.reserve(world.surfaces.size());
    for (const Surface& s : world.surfaces) {
        lit.push_back({make(s), world.lighting, world.camera.eye});
    }
    std::vector<Shader> shaders;
    shaders.reserve(lit.size());
    for (const Lit<Brdf>& shader : lit) {
        shaders.push_back(plug(shader));
    }
    return picture_fault(world, shaders);
}
std::string picture_fault(const World& world);

// The largest value of the four models' BRDFs, 1/sr: Cd/pi, 21/20 of it where it is coupled, and
// the lobe's peak.
double stated_brightest(const Surface& surface, int band);

// The BRDF's albedo at some angle is a number, not negative, and within the bound of the world's
// model: 2 for side by side, 3/2 - F0 or 1 for lesson 15's, 1 by angle, 1.0007 for lesson 16's,
// which is also reciprocal to the bit.
using AnyBrdf = std::function<Rgb<double>(const Incidence<double>&)>;
std::string material_fault(const World& world, const AnyBrdf& brdf);
std::string material_fault(const World& world);

// Lessons 10 and 11 say shares of light, 0..1, for random indices and angles.
std::string fresnel_fault(std::uint64_t seed);

}  // namespace glint::stability
