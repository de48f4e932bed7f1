#include "lessons/11_fresnel_conductor/fresnel_conductor.hpp"
#include "lessons/11_fresnel_conductor/metals.hpp"
#include "lessons/12_schlick/schlick.hpp"
#include "tests/unit/lessons/lane_value.hpp"
#include "tests/worst.hpp"

#include <doctest/doctest.h>

#include <functional>

namespace glint {
namespace {

struct Surface {
    double ior, k;
    double exact(double c) const { return fresnel_conductor(ior, k, c).unpolarised; }
    double F0() const { return f0_conductor(ior, k); }
    double dip() const { return lazanyi_dip(F0(), exact(1.0 / 7)); }
};

Surface metal(std::size_t m, int band) {
    return {double{metals[m].ior[band]}, double{metals[m].k[band]}};
}

// The greatest errors of an approximation over all angles, and where they are, in degrees.
struct Errors {
    double over = 0, over_at = 0, under = 0, under_at = 0, relative = 0, relative_at = 0;
    double worst() const { return std::max(over, -under); }
};

template <class Approximation>
Errors errors_of(const Surface& s, Approximation approximation) {
    Errors e;
    for (double degrees = 0; degrees <= 90; degrees += 0.02) {
        const double c = cos_of_degrees(degrees);
        const double off = approximation(c) - s.exact(c);
        if (off > e.over) {
            e.over = off;
            e.over_at = degrees;
        }
        if (off < e.under) {
            e.under = off;
            e.under_at = degrees;
        }
        if (std::abs(off) / s.exact(c) > e.relative) {
            e.relative = std::abs(off) / s.exact(c);
            e.relative_at = degrees;
        }
    }
    return e;
}

Errors errors_of_schlick(const Surface& s) {
    return errors_of(s, [F0 = s.F0()](double c) { return schlick(F0, c); });
}

TEST_CASE("12.1 and 12.2 F0 is the exact reflectance along the normal") {
    for (const double ior : {0.5, 1.0, 1.33, 1.5, 2.4, 50.0}) {
        CHECK(std::abs(f0_dielectric(ior) - fresnel_dielectric(1.0, ior, 1.0).unpolarised) < 1e-15);
        CHECK(std::abs(f0_dielectric(ior) - f0_dielectric(1 / ior)) < 1e-15);  // from inside
        for (const double k : {0.0, 0.5, 3.0}) {
            const double exact = fresnel_conductor(ior, k, 1.0).unpolarised;
            CHECK(std::abs(f0_conductor(ior, k) - exact) < 1e-14);
        }
    }
    CHECK(f0_dielectric(1.5) == doctest::Approx(0.04));
    // Glass in water: the relative index counts.
    CHECK(f0_dielectric(1.5 / 1.33) ==
          doctest::Approx(fresnel_dielectric(1.33, 1.5, 1.0).parallel));
}

TEST_CASE("12.2 without k, as on the slides, F0 of metals is wrong") {
    struct Row {
        double without[3], with[3];
    };
    constexpr Row rows[] = {{{.53, .16, .03}, {.96, .79, .41}},
                            {{.38, .00, .01}, {.94, .62, .54}},
                            {{.81, .79, .85}, {.99, .98, .98}},
                            {{.05, .00, .05}, {.91, .92, .92}},
                            {{.24, .24, .20}, {.53, .51, .50}}};
    for (std::size_t m = 0; m < metals.size(); ++m) {
        for (int band = 0; band < 3; ++band) {
            CAPTURE(metals[m].name);
            CHECK(std::abs(f0_dielectric(metal(m, band).ior) - rows[m].without[band]) < 0.0051);
            CHECK(std::abs(metal(m, band).F0() - rows[m].with[band]) < 0.0051);
        }
    }
}

TEST_CASE("12.3 Schlick against exact: dielectrics") {
    struct Row {
        double ior, over, over_at, under, under_at, relative, relative_at;
    };
    constexpr Row rows[] = {{1.33, .0599, 83.8, -.0092, 56.7, .23, 51},
                            {1.5, .0357, 85.0, -.0196, 62.3, .23, 56},
                            {2.4, .0740, 84.5, -.0140, 58.5, .14, 82}};
    for (const Row& row : rows) {
        CAPTURE(row.ior);
        const Errors e = errors_of_schlick({row.ior, 0});
        CHECK(std::abs(e.over - row.over) < 6e-5);
        CHECK(std::abs(e.over_at - row.over_at) < 0.11);
        CHECK(std::abs(e.under - row.under) < 6e-5);
        CHECK(std::abs(e.under_at - row.under_at) < 0.11);
        CHECK(std::abs(e.relative - row.relative) < 0.0051);
        CHECK(std::abs(e.relative_at - row.relative_at) < 0.6);
    }
}

TEST_CASE("12.3 Schlick against exact: metals, whose dip it misses") {
    struct Row {
        double over[3], over_at[3], relative[3];
    };
    constexpr Row rows[] = {{{.017, .010, .018}, {78, 74, 84}, {.017, .013, .030}},
                            {{.025, .039, .040}, {79, 80, 82}, {.026, .054, .057}},
                            {{.006, .007, .002}, {80, 78, 73}, {.007, .007, .007}},
                            {{.130, .096, .067}, {84, 83.1, 81.9}, {.16, .11, .075}},
                            {{.178, .176, .149}, {83, 83, 83}, {.31, .31, .31}}};
    for (std::size_t m = 0; m < metals.size(); ++m) {
        for (int band = 0; band < 3; ++band) {
            CAPTURE(metals[m].name);
            CAPTURE(band);
            const Errors e = errors_of_schlick(metal(m, band));
            CHECK(std::abs(e.over - rows[m].over[band]) < 6e-4);
            CHECK(std::abs(e.over_at - rows[m].over_at[band]) < 0.6);
            CHECK(e.relative < rows[m].relative[band] + 0.006);
        }
    }
}

TEST_CASE("the exact reflectance is not stable until 60 or 70 degrees") {
    struct Row {
        double ior, ratio[4];
    };
    constexpr Row rows[] = {{1.33, {1.37, 2.95, 6.6, 17.3}},
                            {1.5, {1.26, 2.23, 4.28, 9.7}},
                            {2.4, {1.05, 1.23, 1.59, 2.56}}};
    constexpr double degrees[] = {45, 60, 70, 80};
    for (const Row& row : rows) {
        const Surface s{row.ior, 0};
        for (int i = 0; i < 4; ++i) {
            CHECK(s.exact(cos_of_degrees(degrees[i])) / s.F0() ==
                  doctest::Approx(row.ratio[i]).epsilon(0.006));
        }
    }
    const Surface glass{1.5, 0};
    CHECK(glass.exact(cos_of_degrees(57.9)) / glass.F0() == doctest::Approx(2).epsilon(0.003));
}

TEST_CASE("from inside a denser medium Schlick needs the refracted angle") {
    for (double degrees = 0; degrees < 41.8; degrees += 0.1) {
        const double cos1 = cos_of_degrees(degrees);
        const double cos2 = refracted_cosine(1.5, 1.0, cos1);
        const double exact = fresnel_dielectric(1.5, 1.0, cos1).unpolarised;
        REQUIRE(std::abs(schlick(0.04, cos2) - exact) < 0.0358);
    }
    // With the angle of incidence it misses the whole rise to total reflection.
    CHECK(schlick(0.04, cos_of_degrees(41.8)) < 0.05);
    CHECK(fresnel_dielectric(1.5, 1.0, cos_of_degrees(41.8)).unpolarised > 0.89);
}

TEST_CASE("at grazing incidence the exact weight falls by about six times the cosine") {
    for (const double n : {1.33, 1.5, 2.0, 2.4}) {
        const Surface s{n, 0};
        const double slope = (1 - s.exact(1e-7)) / 1e-7;
        CHECK(slope == doctest::Approx(2 * (1 + n * n) / std::sqrt(n * n - 1)).epsilon(1e-5));
        CHECK(slope / (1 - s.F0()) > 6.0);
        CHECK(slope / (1 - s.F0()) < 7.5);
    }
    CHECK(schlick_weight(1e-7) == doctest::Approx(1 - 5e-7));
    const auto weight = [](double n) {
        return 2 * (1 + n * n) / std::sqrt(n * n - 1) / (1 - f0_dielectric(n));
    };
    CHECK(std::abs(weight(1.5) - 6.06) < 0.005);
    CHECK(std::abs(weight(1.33) - 6.4) < 0.05);
    CHECK(std::abs(weight(2.4) - 7.5) < 0.05);
}

TEST_CASE("the Gaussian follows Schlick within 0.004, but misses F0 by 0.00017") {
    double worst = 0;
    for (int i = 0; i <= 10000; ++i) {
        const double c = i / 10000.0;
        worst = worse(worst, std::abs(schlick_gaussian(0.0, c) - schlick(0.0, c)));
    }
    CHECK(worst == doctest::Approx(0.0038).epsilon(0.02));
    CHECK(schlick_gaussian(0.0, 1.0) == doctest::Approx(0.00017).epsilon(0.02));
    CHECK(schlick_gaussian(0.04, 0.0) == 1);
}

TEST_CASE("the worst errors of the text, by material") {
    const auto worst = [](std::size_t m, auto errors) {
        double most = 0;
        for (int band = 0; band < 3; ++band) {
            most = std::max(most, errors(metal(m, band)).worst());
        }
        return most;
    };
    const auto by_lazanyi = [](const Surface& s) {
        return errors_of(s, [&](double c) { return lazanyi(s.F0(), s.dip(), c); });
    };
    constexpr double of_schlick[] = {.018, .040, .007, .130, .178};
    constexpr double of_lazanyi[] = {.017, .007, .002, .022, .019};
    for (std::size_t m = 0; m < metals.size(); ++m) {
        CAPTURE(metals[m].name);
        CHECK(std::abs(worst(m, errors_of_schlick) - of_schlick[m]) < 5.1e-4);
        CHECK(std::abs(worst(m, by_lazanyi) - of_lazanyi[m]) < 5.1e-4);
    }
    constexpr double dielectrics[][3] = {{1.33, .060, .020}, {1.5, .036, .028}, {2.4, .074, .030}};
    for (const auto& [ior, schlicks, lazanyis] : dielectrics) {
        CHECK(std::abs(errors_of_schlick({ior, 0}).worst() - schlicks) < 5.1e-4);
        CHECK(std::abs(by_lazanyi({ior, 0}).worst() - lazanyis) < 5.1e-4);
    }
}

TEST_CASE("Lazanyi's form is exact at three angles and stays within 0 and 1") {
    for (std::size_t m = 0; m < metals.size(); ++m) {
        for (int band = 0; band < 3; ++band) {
            const Surface s = metal(m, band);
            const auto F = [&](double c) { return lazanyi(s.F0(), s.dip(), c); };
            CHECK(F(1) == doctest::Approx(s.F0()).epsilon(1e-14));
            CHECK(F(1.0 / 7) == doctest::Approx(s.exact(1.0 / 7)).epsilon(1e-14));
            CHECK(F(0) == doctest::Approx(1).epsilon(1e-14));
            for (int i = 0; i <= 1000; ++i) {
                REQUIRE(F(i / 1000.0) > 0);
                REQUIRE(F(i / 1000.0) <= 1);
            }
        }
    }
}

TEST_CASE_TEMPLATE("12 in every number type", T, float, ALL_LANES) {
    for (const float c : {0.0F, 1e-8F, 1e-4F, 0.01F, 1.0F / 7, 0.3F, 0.5F, 0.9F, 1.0F}) {
        CAPTURE(c);
        const auto near = [](const T& x, double exact) {
            CHECK(std::abs(value(x) - exact) < 1e-6);
        };
        near(schlick_weight(T(c)), schlick_weight(double{c}));
        for (const float F0 : {0.0F, 0.04F, 0.5F, 1.0F}) {
            const auto exact = double{F0};
            near(schlick(T(F0), T(c)), schlick(exact, double{c}));
            near(schlick_gaussian(T(F0), T(c)), schlick_gaussian(exact, double{c}));
            near(lazanyi(T(F0), T(2.0F), T(c)), lazanyi(exact, 2.0, double{c}));
            const Rgb<T> colour = schlick(Rgb<T>(T(F0), T(0.5F), T(1.0F)), T(c));
            near(colour.r, schlick(exact, double{c}));
            near(colour.g, schlick(0.5, double{c}));
            near(colour.b, 1);
        }
    }
    for (const float ior : {0.04F, 0.5F, 1.0F, 1.5F, 1e6F}) {
        CHECK(value(f0_dielectric(T(ior))) == doctest::Approx(f0_dielectric(double{ior})));
        CHECK(value(f0_conductor(T(ior), T(0.0F))) == doctest::Approx(f0_dielectric(double{ior})));
        CHECK(value(f0_conductor(T(ior), T(3.0F))) ==
              doctest::Approx(f0_conductor(double{ior}, 3.0)));
    }
    CHECK(value(lazanyi_dip(T(0.906F), T(0.85F))) ==
          doctest::Approx(lazanyi_dip(0.906, 0.85)).epsilon(1e-5));
}

TEST_CASE_TEMPLATE("12 at its ends", T, float, double, ALL_LANES) {
    for (const float F0 : {0.0F, 0.02F, 0.04F, 0.5F, 0.999F, 1.0F}) {
        CHECK(value(schlick(T(F0), T(1.0F))) == double{F0});
        CHECK(value(schlick(T(F0), T(2.0F))) == double{F0});
        for (const float c : {-1.0F, 0.0F, nan}) {  // at the horizon and below
            CHECK(value(schlick(T(F0), T(c))) == doctest::Approx(1).epsilon(1e-7));
            CHECK(value(schlick_gaussian(T(F0), T(c))) == doctest::Approx(1).epsilon(1e-7));
            CHECK(value(lazanyi(T(F0), T(2.0F), T(c))) == doctest::Approx(1).epsilon(1e-7));
        }
        CHECK(value(schlick(T(F0), T(1e-8F))) == doctest::Approx(1).epsilon(1e-6));
    }
    CHECK(value(f0_dielectric(T(1.0F))) == 0);
    CHECK(value(f0_conductor(T(1.0F), T(0.0F))) == 0);
}

}  // namespace
}  // namespace glint
