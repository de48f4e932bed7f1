// Lights: many, near, small.
#include "lessons/02_radiometry/radiometry.hpp"
#include "lessons/04_rendering_equation/rendering_equation.hpp"
#include "lessons/08_normalised_lambert/normalised_lambert.hpp"
#include "tests/stability/row.hpp"

#include <algorithm>

namespace glint::stability {
namespace {

TEST_CASE("10,000 lights: added pass by pass into 8 bits") {
    const int count = 10'000;
    const float E = 1e-4F * std::numbers::pi_v<float> * 0.9F;
    const Lighting lighting{
        .directional = std::vector<DirectionalLight>(count, {{0, 0, 1}, Rgb<float>(E)}),
        .point = {},
        .ambient = Rgb<float>(0)};
    const Lit<NormalisedLambert> lit{{Rgb<float>(1)}, lighting, {0, 0, 3}};
    const double exact = count * double{E} / pi;
    row(in_all_numbers([&]<Real T>() {
            int code = 0;
            for (int i = 0; i < count; ++i) {
                code += static_cast<int>(std::lround(255 * double{E} / pi));
            }
            const Vec3<T> N(T(0.0F), T(0.0F), T(1.0F));
            const Lit<NormalisedLambert>::Varyings<T> at{Vec3<T>(T(0.0F)), N};
            return Errors{std::abs(code / 255.0 - exact) / exact,
                          std::abs(value(lit(at).g) - exact) / exact};
        }),
        0.5, count * 0x1p-24);
}

TEST_CASE("a disk of light as a point") {
    // At a hundredth of its radius below its middle: over pi L, the disk gives almost 1.
    const double exact = 1 / (1 + 1e-4);
    row(in_all_numbers([&]<Real T>() {
            const T radius(1.0F);
            const T below(0.01F);
            const T as_point = radius * radius / (below * below);
            return Errors{std::abs(value(as_point) - exact) / exact,
                          std::abs(value(irradiance_of_disk(radius, below, T(0.0F)).y) - exact)};
        }),
        1e3, 1e-6);
}

TEST_CASE("a far disk of light by (1 - cos)/2") {
    row(in_floats([]<Real T>() {
            const double h = 1e4;
            const double exact = 1 / (1 + h * h);
            const T p = T(h * h - 1);
            const T q = T(h * h + 1);
            const T far = irradiance_of_disk(T(1.0F), T(h), T(0.0F)).y;
            return Errors{std::abs(value(T(0.5F) - T(0.5F) * (p / q)) / exact - 1),
                          std::abs(value(far) / exact - 1)};
        }),
        0.5, 1e-6);
}

TEST_CASE("a point light at distance 0") {
    const Lighting lighting{.directional = {}, .point = {{}}, .ambient = Rgb<float>(0)};
    const Lit<NormalisedLambert> lit{{Rgb<float>(1)}, lighting, {0, 0, 3}};
    row(in_all_numbers([&]<Real T>() {
            const Vec3<T> way(T(0.0F));
            const Vec3<T> N(T(0.0F), T(0.0F), T(1.0F));
            const T naive = dot(N, normalize(way)) * T(1.0F) / dot(way, way);
            const Lit<NormalisedLambert>::Varyings<T> in_its_place{way, N};
            return Errors{value(naive), value(lit(in_its_place).g)};
        }),
        infinite, 0);
}

TEST_CASE("a point light at distance 1e-20") {
    const Lighting lighting{.directional = {}, .point = {{}}, .ambient = Rgb<float>(0)};
    const double most = 1 / (double{nearest_point_light} * double{nearest_point_light});
    row(in_floats([&]<Real T>() {
            const T d(1e-20F);
            double arrives = 0;
            for_each_light(lighting, Vec3<T>(d, d, d),
                           [&](const Incident<T>& light) { arrives = value(light.irradiance.g); });
            return Errors{value(T(1.0F) / (d * d)), arrives};
        }),
        infinite, most * 1.000001);
}

}  // namespace
}  // namespace glint::stability
