#include "tests/grading/picture.hpp"

#include "framework/image/convert.hpp"
#include "framework/image/flip.hpp"
#include "framework/image/heat_map.hpp"
#include "tests/grading/judge.hpp"

#include <cmath>

namespace glint::grading {
namespace {

double wanted(const Check& c) {
    return (c.low + c.high) / 2;
}

// In a frame every answer has its check, of itself alone.
std::vector<double> right_answers(const Batch& batch) {
    std::vector<double> all;
    all.reserve(batch.checks.size());
    for (const Check& c : batch.checks) {
        all.push_back(wanted(c));
    }
    return all;
}

SrgbImage picture_of(const Batch& batch, std::span<const double> answers) {
    const Frame& f = batch.frame;
    LinearImage image(f.width, f.height, Rgb<float>(0.0F));
    for (std::size_t row = 0; row < f.pixels.size(); ++row) {
        Rgb<float>& pixel = image.pixels()[static_cast<std::size_t>(f.pixels[row])];
        for (std::size_t i = 0; i < 3; ++i) {
            const std::size_t answer = row * batch.answers_a_row + i % batch.answers_a_row;
            pixel[static_cast<int>(i)] = static_cast<float>(answers[answer] * f.light[row]);
        }
    }
    return to_srgb(image);
}

std::string raster_of(const Batch& batch, std::span<const double> answers) {
    const Frame& f = batch.frame;
    std::string raster(static_cast<std::size_t>((f.width + 1) * f.height), '.');
    for (std::size_t i = 0; i < answers.size(); ++i) {
        const auto first = static_cast<std::size_t>(f.pixels[i / batch.answers_a_row]);
        const std::size_t pixel = first + i % batch.answers_a_row;
        const bool is_due = wanted(batch.checks[i]) != 0;
        raster[pixel + pixel / static_cast<std::size_t>(f.width)] =
            passes(batch.checks[i], answers) ? (is_due ? '#' : '.') : (is_due ? '?' : '!');
    }
    for (int y = 1; y <= f.height; ++y) {
        raster[static_cast<std::size_t>(y * (f.width + 1) - 1)] = '\n';
    }
    return raster;
}

}  // namespace

Shown show(const Case& asked, const Batch& batch, std::span<const double> answers) {
    if (asked.kind == "coverage") {
        return {{}, raster_of(batch, answers)};
    }
    const SrgbImage expected = picture_of(batch, right_answers(batch));
    const SrgbImage made = picture_of(batch, answers);
    return {side_by_side(expected, made, heat_map(flip_map(expected, made))), ""};
}

std::size_t worst_failure(const Batch& batch, std::span<const double> answers) {
    std::size_t worst = 0;
    double most = -1;
    for (std::size_t i = 0; i < batch.checks.size(); ++i) {
        const double seen = std::abs(answers[i] - wanted(batch.checks[i])) *
                            batch.frame.light[i / batch.answers_a_row];
        const double off = std::isfinite(seen) ? seen : INFINITY;
        if (!passes(batch.checks[i], answers) && off > most) {
            most = off;
            worst = i;
        }
    }
    return worst;
}

std::string place_of(const Batch& batch, std::size_t check) {
    const Frame& f = batch.frame;
    const int pixel =
        f.pixels[check / batch.answers_a_row] +
        (batch.answers_a_row == 3 ? 0 : static_cast<int>(check % batch.answers_a_row));
    return "pixel " + std::to_string(pixel % f.width) + ',' + std::to_string(pixel / f.width);
}

}  // namespace glint::grading
