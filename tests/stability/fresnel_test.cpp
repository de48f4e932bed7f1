// Fresnel's reflectances: 0/0, roots of negative numbers, differences of nearly equal ones.
#include "lessons/11_fresnel_conductor/fresnel_conductor.hpp"
#include "lessons/11_fresnel_conductor/metals.hpp"
#include "lessons/12_schlick/schlick.hpp"
#include "tests/stability/row.hpp"

#include <algorithm>
#include <complex>

namespace glint::stability {
namespace {

TEST_CASE("Schlick by exp2(5 log2(1 - cos)): cos rounded above 1") {
    row(in_all_numbers([]<Real T>() {
            const T cosine(1.0F + 0x1p-23F);
            const T naive = exp2(T(5.0F) * log2(T(1.0F) - cosine));
            return Errors{std::abs(value(naive)), value(schlick(T(0.0F), cosine))};
        }),
        infinite, 0);
}

TEST_CASE("1 - cos where cos is near 1: its digits, and what becomes of them") {
    row(in_floats([]<Real T>() {
            Errors worst;
            for (const double angle : {1e-4, 1e-3, 1e-2}) {
                const double exact = 2 * std::pow(std::sin(angle / 2), 2);
                const T cosine = T(std::cos(angle));
                // As a share of 1 - cos; as a reflectance, where the fifth power hides it.
                add(worst, {std::abs(value(T(1.0F) - cosine) - exact) / exact,
                            std::abs(value(schlick(T(0.0F), cosine)) - std::pow(exact, 5))});
            }
            return worst;
        }),
        0.9, 1e-20);
}

// By the sine, as Snell's law is printed.
template <Real T>
T dielectric_by_sine(T n1, T n2, T c1) {
    const T sine = n1 / n2 * sqrt(T(1.0F) - c1 * c1);
    const T c2 = sqrt(T(1.0F) - sine * sine);
    const T par = (n1 * c2 - n2 * c1) / (n1 * c2 + n2 * c1);
    const T perp = (n1 * c1 - n2 * c2) / (n1 * c1 + n2 * c2);
    return T(0.5F) * (par * par + perp * perp);
}
template <Real T>
Errors dielectric_errors(float n1, float n2, float c, double exact) {
    return {std::abs(value(dielectric_by_sine(T(n1), T(n2), T(c))) - exact),
            std::abs(value(fresnel_dielectric(T(n1), T(n2), T(c)).unpolarised) - exact)};
}

TEST_CASE("Fresnel, dielectric: equal indices at grazing incidence") {
    row(in_all_numbers([]<Real T>() { return dielectric_errors<T>(1.5F, 1.5F, 0, 0); }), infinite,
        0);
}

TEST_CASE("Fresnel, dielectric: beyond the critical angle") {
    row(in_all_numbers([]<Real T>() { return dielectric_errors<T>(1.5F, 1, 0.7F, 1); }), infinite,
        0);
}

TEST_CASE("Fresnel, dielectric: nearly equal indices near grazing") {
    const float n2 = 1 + 0x1p-22F;
    row(in_all_numbers([&]<Real T>() {
            Errors worst;
            for (float c = 1e-4F; c < 1e-2F; c *= 1.3F) {
                const double exact = fresnel_dielectric(1.0, double{n2}, double{c}).unpolarised;
                add(worst, dielectric_errors<T>(1, n2, c, exact));
            }
            return worst;
        }),
        0.02, 1e-6);
}

TEST_CASE("Fresnel, dielectric: at the critical angle") {
    // R falls from 1 with an infinite slope: there the cosine's own last digit is worth this much.
    const double critical = std::sqrt(1 - 1 / 2.25);
    row(in_all_numbers([&]<Real T>() {
            Errors worst;
            for (int ulps = -40; ulps <= 40; ++ulps) {
                const auto c = static_cast<float>(critical + ulps * 0x1p-24);
                const double exact = fresnel_dielectric(1.5, 1.0, double{c}).unpolarised;
                add(worst, dielectric_errors<T>(1.5F, 1, c, exact));
            }
            return worst;
        }),
        infinite, 3e-3);
}

Reflectances<double> by_complex_numbers(double ior, double k, double c1) {
    const std::complex<double> n2(ior, k);
    const std::complex<double> sine = std::sqrt(1 - c1 * c1) / n2;
    const std::complex<double> c2 = std::sqrt(1.0 - sine * sine);
    const double par = std::norm((c2 - n2 * c1) / (c2 + n2 * c1));
    const double perp = std::norm((c1 - n2 * c2) / (c1 + n2 * c2));
    return {par, perp, (par + perp) / 2};
}

// Through a^2 + b^2 and a, as the conductor's formula is often written, R_perp of it.
template <Real T>
T conductor_by_squares(T ior, T k, T c) {
    const T q = ior * ior - k * k - (T(1.0F) - c * c);
    const T root = sqrt(q * q + T(4.0F) * ior * ior * k * k);
    const T a = sqrt(T(0.5F) * (root + q));
    return (root - T(2.0F) * a * c + c * c) / (root + T(2.0F) * a * c + c * c);
}

TEST_CASE("Fresnel, conductor: k much greater than the index") {
    const float ior = 0.05F;
    row(in_all_numbers([&]<Real T>() {
            Errors worst;  // of what is absorbed
            for (float k = 40; k < 120; k += 7) {
                const double exact =
                    1 - by_complex_numbers(double{ior}, double{k}, 1).perpendicular;
                const T one(1.0F);
                const T naive = one - conductor_by_squares(T(ior), T(k), one);
                const T glint = one - fresnel_conductor(T(ior), T(k), one).perpendicular;
                add(worst,
                    {std::abs(value(naive) / exact - 1), std::abs(value(glint) / exact - 1)});
            }
            return worst;
        }),
        0.05, 0.01);
}

TEST_CASE("Fresnel, conductor: nearly the air's index") {
    row(in_all_numbers([]<Real T>() {
            Errors below;  // 0
            for (float c = 0.3F; c < 1; c += 0.0137F) {
                const T naive = conductor_by_squares(T(1.00005F), T(1e-5F), T(c));
                const T glint = fresnel_conductor(T(1.00005F), T(1e-5F), T(c)).perpendicular;
                add(below, {-value(naive), -value(glint)});
            }
            return below;
        }),
        1e-8, 0);
}

// a^2 - b^2 as (ior - 1)(ior + 1) - k^2 + c^2 at every angle: right near grazing incidence.
template <Real T>
T conductor_from_grazing(T ior, T k, T c) {
    const T q = (ior - T(1.0F)) * (ior + T(1.0F)) - k * k + c * c;
    const T root = sqrt(q * q + T(4.0F) * ior * ior * k * k);
    const T a = sqrt(T(0.5F) * (root + q));
    const T b2 = T(0.5F) * (root - q);
    return ((a - c) * (a - c) + b2) / ((a + c) * (a + c) + b2);
}

TEST_CASE("Fresnel, conductor: index and k far below 1") {
    row(in_all_numbers([]<Real T>() {
            Errors worst;
            for (const float ior : {1e-4F, 2e-4F, 1e-3F, 1e-2F}) {
                for (const float k : {0.0F, 1e-5F, 1e-4F, 1e-2F}) {
                    const double exact = by_complex_numbers(double{ior}, double{k}, 1).unpolarised;
                    const T R = fresnel_conductor(T(ior), T(k), T(1.0F)).unpolarised;
                    const T naive = conductor_from_grazing(T(ior), T(k), T(1.0F));
                    add(worst, {std::abs(value(naive) - exact), std::abs(value(R) - exact)});
                }
            }
            return worst;
        }),
        1e-4, 1e-6);
}

TEST_CASE("Fresnel, conductor: as the slides print it") {
    const auto printed = []<Real T>(T ior, T k, T c) {
        const T q = (ior * ior + k * k) * c * T(2.0F);
        const T both = T(2.0F) * ior * c;
        const T par = (q - both + T(1.0F)) / (q + both + T(1.0F));
        const T perp = (q - both + c * c) / (q + both + c * c);
        return T(0.5F) * (par + perp);
    };
    const auto gold = [](const auto& reflectance) {  // from along the normal to grazing
        return [&](int x, int) {
            Rgb<float> F;
            for (int band = 0; band < 3; ++band) {
                const auto c = static_cast<float>(std::cos(x * pi / 130));
                F[band] = reflectance(metals[0].ior[band], metals[0].k[band], c);
            }
            return F;
        };
    };
    const auto by_glint = [](float ior, float k, float c) {
        return fresnel_conductor(ior, k, c).unpolarised;
    };
    picture("printed_gold", 65, 16, 3, gold(printed), gold(by_glint));
    row(in_all_numbers([&]<Real T>() {
            Errors worst;
            for (const Metal& metal : metals) {
                for (float c = 0.01F; c <= 1; c += 0.01F) {
                    const T ior(metal.ior.g);
                    const T k(metal.k.g);
                    const double exact =
                        by_complex_numbers(value(ior), value(k), double{c}).unpolarised;
                    add(worst,
                        {std::abs(value(printed(ior, k, T(c))) - exact),
                         std::abs(value(fresnel_conductor(ior, k, T(c)).unpolarised) - exact)});
                }
            }
            return worst;
        }),
        0.2, 1e-6);
}

}  // namespace
}  // namespace glint::stability
