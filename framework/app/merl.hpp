// Measured BRDFs as the MERL database keeps them (Matusik, Pfister, Brand and McMillan 2003): a
// ".binary" file is three 32-bit integers, the counts of theta_half, theta_difference and
// phi_difference (there 90, 90, 180), then that many doubles of red, as many of green and of blue.
// All is little-endian.
#pragma once

#include "framework/math/vec.hpp"

#include <filesystem>
#include <vector>

namespace glint {

// Values in 1/sr at the middles of cells: theta_half is 90 degrees times the square of
// (i + 1/2) / half, theta_difference 90 (j + 1/2) / difference, phi_difference
// 180 (k + 1/2) / azimuth. The last runs fastest. Negative: not measured.
struct MerlBrdf {
    int half = 90, difference = 90, azimuth = 180;
    std::vector<Rgb<double>> values{};
};

// What the file's numbers are multiplied by to become 1/sr.
inline constexpr double merl_scale[] = {1 / 1500.0, 1.15 / 1500.0, 1.66 / 1500.0};

// Error: no such file, no counts of 1..512, not exactly the bytes that they announce, or a value
// that is not finite.
MerlBrdf read_merl(const std::filesystem::path& path);

// The file appears complete or not at all. Error where it cannot be written.
void write_merl(const std::filesystem::path& path, const MerlBrdf& brdf);

}  // namespace glint
