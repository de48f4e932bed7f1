// Samples of a pixel: which are covered, what the pixel becomes, and where it is shaded.
#include "framework/raster/fragment.hpp"
#include "framework/raster/plug.hpp"
#include "framework/raster/samples.hpp"
#include "framework/image/srgb.hpp"
#include "tests/oracle/cases.hpp"
#include "tests/oracle/coverage_oracle.hpp"
#include "tests/unit/math/lane_types.hpp"
#include "tests/unit/raster/drawing.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <cstdlib>
#include <map>
#include <utility>
#include <vector>

namespace glint {
namespace {

using oracle::Random;

constexpr int sample_counts[] = {1, 2, 4, 8, 16};

Mesh mesh_of(const oracle::Triangle& triangle) {
    Mesh mesh;
    for (const oracle::Point& p : triangle) {
        mesh.positions.emplace_back(static_cast<float>(p.x) / 256, static_cast<float>(p.y) / 256,
                                    0.5F);
    }
    mesh.uvs = {{1, 0}, {0, 1}, {0, 0}};
    mesh.triangles = {{0, 1, 2}};
    return mesh;
}

// A sum over a pixel's samples tells which of them it saw: sample i adds 2^i.
struct SampleBits {
    int samples = 1;

    template <class T>
    struct Varyings {
        Vec2<T> window;
    };
    static Varyings<float> vertex(const Vertex& v) { return {Vec2<float>(v.position)}; }
    template <Real T>
    Rgb<T> operator()(const Varyings<T>& in) const {
        T bits(0.0F);
        if constexpr (!std::same_as<T, double>) {
            const T x = from_centre(in.window.x);
            const T y = from_centre(in.window.y);
            float bit = 1;
            for (const SampleOffset o : sample_offsets(samples)) {
                const T dx = abs(x - T(static_cast<float>(o.x) / 256));
                const T dy = abs(y - T(static_cast<float>(o.y) / 256));
                const auto here = (dx < T(1.0F / 40)) & (dy < T(1.0F / 40));
                bits += select(here, T(bit), T(0.0F));
                bit *= 2;
            }
        }
        return Rgb<T>(bits);
    }

    // Some samples lie on their pixel's border: 1/32 pixel keeps them off the next one's.
    template <Real T>
    static T from_centre(const T& position) {
        const T moved = position + T(1.0F / 32);
        return moved - to_float(truncate_to_int(moved)) - T(0.5F + 1.0F / 32);
    }
};

TEST_CASE("the sample positions are Direct3D's, nearest to the centre first") {
    for (const int samples : sample_counts) {
        const auto offsets = sample_offsets(samples);
        const auto exact = oracle::sample_positions(samples);
        REQUIRE(offsets.size() == exact.size());
        for (std::size_t i = 0; i < offsets.size(); ++i) {
            CHECK(oracle::Point{offsets[i].x + 128, offsets[i].y + 128} == exact[i]);
            const auto away = [&](std::size_t k) {
                return offsets[k].x * offsets[k].x + offsets[k].y * offsets[k].y;
            };
            CHECK(away(0) <= away(i));
        }
    }
    for (const int samples : {-1, 0, 3, 5, 15, 17, 32}) {
        CHECK_THROWS_AS(sample_offsets(samples), Error);
    }
}

// Said in other words: a pixel's triangles, each with its first sample and how many it won.
std::map<std::int32_t, std::pair<std::size_t, int>> winners(const std::vector<std::int32_t>& won) {
    std::map<std::int32_t, std::pair<std::size_t, int>> all;
    for (std::size_t s = 0; s < won.size(); ++s) {
        if (won[s] >= 0) {
            ++all.try_emplace(won[s], s, 0).first->second.second;
        }
    }
    return all;
}

TEST_CASE_TEMPLATE("fragments are a pixel's triangles, in every lane", F, float, ALL_LANES) {
    using I = IntOf<F>;
    constexpr int n = lanes_of<F>;
    Random random(8);
    for (int round = 0; round < 300; ++round) {
        const auto samples = static_cast<std::size_t>(sample_counts[round % 5]);
        const int most = random.between(0, 4);  // triangles
        std::vector<I> won(samples);
        std::vector<std::vector<std::int32_t>> of_pixel(n, std::vector<std::int32_t>(samples));
        for (std::size_t s = 0; s < samples; ++s) {
            std::int32_t lanes[n];
            for (int i = 0; i < n; ++i) {
                lanes[i] = random.between(-1, most);
                of_pixel[static_cast<std::size_t>(i)][s] = lanes[i];
            }
            won[s] = load<I>(lanes);
        }
        std::vector<std::map<std::int32_t, std::pair<std::size_t, int>>> once(n);
        resolve_pixels<I>(
            won, false,
            [&](MaskOf<F> where, const I& triangle, std::size_t sample, const I& count) {
                for (int i = 0; i < n; ++i) {
                    if (lane(where, i)) {
                        auto& known = once[static_cast<std::size_t>(i)];
                        CHECK(known.try_emplace(lane(triangle, i), sample, lane(count, i)).second);
                    }
                }
            });
        std::vector<std::vector<std::int32_t>> each(
            n, std::vector<std::int32_t>(samples, no_triangle));
        resolve_pixels<I>(
            won, true, [&](MaskOf<F> where, const I& triangle, std::size_t sample, const I& count) {
                for (int i = 0; i < n; ++i) {
                    if (lane(where, i)) {
                        each[static_cast<std::size_t>(i)][sample] = lane(triangle, i);
                        CHECK(lane(count, i) == 1);
                    }
                }
            });
        for (std::size_t i = 0; i < of_pixel.size(); ++i) {
            CHECK(once[i] == winners(of_pixel[i]));
            CHECK(each[i] == of_pixel[i]);
        }
    }
}

// Fat enough for the interpolated position to tell samples apart.
bool is_fat(const oracle::Triangle& t) {
    return std::abs(doubled_area(t[0], t[1], t[2])) > 256 * 256 * 8;
}

TEST_CASE("the covered samples are those of exact arithmetic") {
    int tried = 0;
    long edge_pixels = 0;
    for (std::uint64_t seed = 1; tried < 40; ++seed) {
        CAPTURE(seed);
        Random random(seed);
        const int samples = sample_counts[random.between(0, 4)];
        const int width = random.between(1, 90);
        const int height = random.between(1, 90);
        const auto anywhere = [&] {
            return oracle::Point{random.between(-20 * 256, (width + 20) * 256),
                                 random.between(-20 * 256, (height + 20) * 256)};
        };
        const oracle::Triangle triangle{anywhere(), anywhere(), anywhere()};
        if (!is_fat(triangle)) {
            continue;
        }
        ++tried;
        const SampleBits shader{samples};
        for (const Settings& settings :
             both_rasterizers({.samples = samples, .sample_shading = true})) {
            CAPTURE(words(settings));
            const Drawn d =
                draw(mesh_of(triangle), window_view(width, height), plug(shader), settings);
            int wrong = 0;
            for (int y = 0; y < height; ++y) {
                for (int x = 0; x < width; ++x) {
                    unsigned expected = 0;
                    unsigned bit = 1;
                    for (const oracle::Point& at : oracle::sample_positions(samples)) {
                        expected |= covers(triangle, {x * 256 + at.x, y * 256 + at.y}) ? bit : 0;
                        bit *= 2;
                    }
                    const float bits = d.linear(x, y).r * static_cast<float>(samples);
                    wrong += bits != static_cast<float>(expected) ? 1 : 0;
                    edge_pixels += expected != 0 && expected != bit - 1 ? 1 : 0;
                }
            }
            CHECK(wrong == 0);
        }
    }
    CHECK(edge_pixels > 1000);
}

int covered_samples(const oracle::Triangle& triangle, int samples, int x, int y) {
    int count = 0;
    for (const oracle::Point& at : oracle::sample_positions(samples)) {
        count += covers(triangle, {x * 256 + at.x, y * 256 + at.y}) ? 1 : 0;
    }
    return count;
}

TEST_CASE("a pixel at an edge is the exact mixture of linear light") {
    const oracle::Triangle triangle{oracle::Point{700, 300}, oracle::Point{2000, 10000},
                                    oracle::Point{11000, 4000}};
    const OneColour shader{{4.0F, 0.5F, 0.0F}};
    const Rgb<float> background(0.0F, 0.25F, 1.0F);
    for (const int samples : sample_counts) {
        for (const bool sample_shading : {false, true}) {
            for (const Settings& settings :
                 both_rasterizers({.samples = samples, .sample_shading = sample_shading})) {
                CAPTURE(words(settings));
                const Drawn d = draw(mesh_of(triangle), window_view(50, 45), plug(shader), settings,
                                     background);
                int wrong = 0;
                for (int y = 0; y < 45; ++y) {
                    for (int x = 0; x < 50; ++x) {
                        const float share =
                            static_cast<float>(covered_samples(triangle, samples, x, y)) /
                            static_cast<float>(samples);
                        const Rgb<float> mixed = background + (shader.colour - background) * share;
                        const Rgba8 code{linear_to_srgb(mixed.r), linear_to_srgb(mixed.g),
                                         linear_to_srgb(mixed.b), 255};
                        wrong += d.linear(x, y) != mixed || !(d.srgb(x, y) == code) ? 1 : 0;
                    }
                }
                CHECK(wrong == 0);
            }
        }
    }
}

TEST_CASE("two triangles share a pixel as their samples do") {
    // They meet along a diagonal and fill the window.
    Mesh mesh{.positions = {{-1, -1, 0.5F}, {41, -1, 0.5F}, {41, 33, 0.5F}, {-1, 33, 0.5F}},
              .normals = {},
              .uvs = {},
              .triangles = {{0, 1, 2}, {0, 2, 3}},
              .materials = {0, 1}};
    const OneColour red{{1, 0, 0}};
    const OneColour green{{0, 1, 0}};
    const std::vector<Shader> shaders{plug(red), plug(green)};
    for (const int samples : sample_counts) {
        for (const Settings& settings : both_rasterizers({.samples = samples})) {
            CAPTURE(words(settings));
            const Drawn d = draw(mesh, window_view(40, 32), shaders, settings, Rgb<float>(7.0F));
            int wrong = 0;
            int mixed = 0;
            for (const Rgb<float>& c : d.linear.pixels()) {
                wrong += c.r + c.g != 1.0F || c.b != 0.0F ? 1 : 0;
                wrong += std::fmod(c.r * static_cast<float>(samples), 1.0F) != 0.0F ? 1 : 0;
                mixed += c.r > 0 && c.g > 0 ? 1 : 0;
            }
            CHECK(wrong == 0);
            CHECK((mixed > 0) == (samples > 1));
            CHECK(d.statistics.fragments_shaded == 40 * 32 + mixed);
        }
    }
}

TEST_CASE("a triangle is never shaded outside of itself") {
    // Slivers too: their interpolants are the steepest.
    double lowest = 1;
    double highest = 0;
    for (std::uint64_t seed = 1; seed <= 300; ++seed) {
        CAPTURE(seed);
        Random random(seed);
        const int width = 80;
        const auto anywhere = [&] {
            return oracle::Point{random.between(-10 * 256, 90 * 256),
                                 random.between(-10 * 256, 90 * 256)};
        };
        oracle::Triangle triangle{anywhere(), anywhere(), anywhere()};
        if (random.one_in(2)) {
            const int thickness = random.one_in(2) ? 200 : 3;
            triangle[2] = {triangle[1].x + random.between(-thickness, thickness),
                           triangle[1].y + random.between(-thickness, thickness)};
        }
        const Mesh mesh = mesh_of(triangle);
        const int samples = sample_counts[random.between(0, 4)];
        for (const Settings& settings :
             both_rasterizers({.samples = samples, .sample_shading = random.one_in(2)})) {
            CAPTURE(words(settings));
            const Drawn d = draw(mesh, window_view(width, width), plug(show_uv), settings);
            double low = 1;
            double high = 0;
            for (const Rgb<float>& c : d.linear.pixels()) {
                if (c.b > 0) {  // the share of the pixel
                    const double u = c.r / c.b;
                    const double v = c.g / c.b;
                    low = std::min({low, u, v, 1 - u - v});
                    high = std::max({high, u, v, 1 - u - v});
                }
            }
            CHECK(low >= -1e-5);
            CHECK(high <= 1 + 1e-5);
            lowest = std::min(lowest, low);
            highest = std::max(highest, high);
        }
    }
    MESSAGE("barycentrics within ", lowest, " and 1 + ", highest - 1);
}

}  // namespace
}  // namespace glint
