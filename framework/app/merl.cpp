#include "framework/app/merl.hpp"

#include "framework/image/file.hpp"
#include "framework/math/error.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>
#include <string>

namespace glint {
namespace fs = std::filesystem;
namespace {

static_assert(std::endian::native == std::endian::little);

using Counts = std::int32_t[3];
constexpr std::int32_t most = 512;

[[noreturn]] void fail(const fs::path& path, const std::string& reason) {
    throw Error("cannot read MERL BRDF '" + path.string() + "': " + reason);
}

std::string in_words(const Counts& n) {
    return std::to_string(n[0]) + " x " + std::to_string(n[1]) + " x " + std::to_string(n[2]);
}

std::size_t product(const Counts& n) {
    return static_cast<std::size_t>(n[0]) * static_cast<std::size_t>(n[1]) *
           static_cast<std::size_t>(n[2]);
}

void check(const fs::path& path, const Counts& counts, std::size_t size) {
    if (std::any_of(counts, counts + 3, [](std::int32_t n) { return n < 1 || n > most; })) {
        fail(path, "its header says " + in_words(counts) + " angles, not 1 to 512 each");
    }
    const std::size_t expected = sizeof counts + 3 * sizeof(double) * product(counts);
    if (size != expected) {
        fail(path, "its header announces " + in_words(counts) + " angles in " +
                       std::to_string(expected) + " bytes, it holds " + std::to_string(size));
    }
}

}  // namespace

MerlBrdf read_merl(const fs::path& path) {
    const std::vector<std::byte> bytes = read_file(path);
    Counts counts{};
    if (bytes.size() < sizeof counts) {
        fail(path, "it is too short for a header");
    }
    std::memcpy(counts, bytes.data(), sizeof counts);
    check(path, counts, bytes.size());
    MerlBrdf brdf{counts[0], counts[1], counts[2], {}};
    brdf.values.resize(product(counts));
    const std::byte* from = bytes.data() + sizeof counts;
    for (int colour = 0; colour < 3; ++colour) {
        for (Rgb<double>& value : brdf.values) {
            double number = 0;
            std::memcpy(&number, from, sizeof number);
            from += sizeof number;
            if (!std::isfinite(number)) {
                fail(path, "it holds a value that is not finite");
            }
            value[colour] = number * merl_scale[colour];
        }
    }
    return brdf;
}

void write_merl(const fs::path& path, const MerlBrdf& brdf) {
    const Counts counts{brdf.half, brdf.difference, brdf.azimuth};
    std::vector<std::byte> bytes(sizeof counts + 3 * sizeof(double) * brdf.values.size());
    std::memcpy(bytes.data(), counts, sizeof counts);
    std::byte* to = bytes.data() + sizeof counts;
    for (int colour = 0; colour < 3; ++colour) {
        for (const Rgb<double>& value : brdf.values) {
            const double number = value[colour] / merl_scale[colour];
            std::memcpy(to, &number, sizeof number);
            to += sizeof number;
        }
    }
    write_file(path, bytes);
}

}  // namespace glint
