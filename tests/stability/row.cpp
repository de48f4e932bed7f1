#include "tests/stability/row.hpp"

#include "framework/image/png.hpp"
#include "framework/image/srgb.hpp"

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <optional>

namespace glint::stability {
namespace {

std::optional<std::filesystem::path> atlas() {
    const char* folder = std::getenv("GLINT_ATLAS");  // NOLINT(concurrency-mt-unsafe)
    return folder == nullptr ? std::nullopt : std::optional<std::filesystem::path>(folder);
}

std::string words(double error) {
    if (std::isnan(error)) {
        return "NaN";
    }
    if (std::isinf(error)) {
        return "infinite";
    }
    const int power = error == 0 ? 0 : static_cast<int>(std::floor(std::log10(std::abs(error))));
    char text[32];
    if (power < -3 || power > 4) {
        std::snprintf(text, sizeof text, "%.2ge%d", error / std::pow(10.0, power), power);
    } else {
        std::snprintf(text, sizeof text, power < 2 ? "%.2g" : "%.0f", error);
    }
    return text;
}

Rgba8 opaque(const Rgb<float>& c) {
    return {linear_to_srgb(c.r), linear_to_srgb(c.g), linear_to_srgb(c.b), 255};
}

}  // namespace

void row(const Errors& e, double fails, double bound) {
    CHECK(or_infinite(e.naive) >= fails);
    CHECK(or_infinite(e.glint) <= bound);
    if (const auto folder = atlas()) {
        std::ofstream rows(*folder / "rows", std::ios::app);
        rows << doctest::getContextOptions()->currentTest->m_name << '\t' << words(e.naive) << '\t'
             << words(e.glint) << '\t' << words(bound) << '\n';
    }
}

void picture(const std::string& name, int width, int height, int magnify, const Shade& naive,
             const Shade& glint) {
    const auto folder = atlas();
    if (!folder) {
        return;
    }
    const int gap = 1;
    SrgbImage image(magnify * (2 * width + gap), magnify * height, {255, 255, 255, 255});
    for (int y = 0; y < image.height(); ++y) {
        for (int x = 0; x < image.width(); ++x) {
            const int column = x / magnify;
            if (column < width) {
                image(x, y) = opaque(naive(column, y / magnify));
            } else if (column >= width + gap) {
                image(x, y) = opaque(glint(column - width - gap, y / magnify));
            }
        }
    }
    write_png(*folder / (name + ".png"), image);
}

}  // namespace glint::stability
