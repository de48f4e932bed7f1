#include "lessons/03_brdf/brdf.hpp"
#include "lessons/07_measured_brdf/capture.hpp"
#include "tests/unit/lessons/lane_value.hpp"
#include "tests/worst.hpp"

#include <doctest/doctest.h>

#include <random>

namespace glint {
namespace {

using Direction = Vec3<double>;

constexpr double right = pi / 2;

Direction direction(double theta, double phi) {
    return {std::sin(theta) * std::cos(phi), std::sin(theta) * std::sin(phi), std::cos(theta)};
}

// The angles by vectors, as Rusinkiewicz 1998 has them: turn H to the pole, see where L is then.
struct Angles {
    double half, difference, azimuth;
};
Angles angles_of(const Direction& L, const Direction& V) {
    const Direction H = normalize(L + V);
    const double theta = std::acos(std::min(H.z, 1.0));
    const double phi = std::atan2(H.y, H.x);
    const Direction a(L.x * std::cos(phi) + L.y * std::sin(phi),
                      L.y * std::cos(phi) - L.x * std::sin(phi), L.z);
    const Direction d(a.x * std::cos(theta) - a.z * std::sin(theta), a.y,
                      a.x * std::sin(theta) + a.z * std::cos(theta));
    return {theta, std::acos(std::min(d.z, 1.0)), std::atan2(d.y, d.x)};
}

LambertPhong paint(float n) {
    return {Rgb<float>(0.05F, 0.12F, 0.3F), Rgb<float>(0.6F), n};
}

template <class Brdf>
MeasuredBrdf measured(const Brdf& brdf, int size) {
    return {table_of(capture(brdf, size, size, 2 * size))};
}

// Pairs of directions, spread evenly over both hemispheres.
std::vector<Incidence<double>> pairs(int count) {
    std::mt19937 random(7);
    std::uniform_real_distribution<double> u(0, 1);
    std::vector<Incidence<double>> all;
    for (int i = 0; i < count; ++i) {
        const double theta_L = std::acos(u(random));
        const double theta_V = std::acos(u(random));
        all.push_back(incidence_of_angles(theta_L, theta_V, 2 * pi * u(random)));
    }
    return all;
}

TEST_CASE("07.1 and 07.2 the place by cosines is the place by vectors") {
    std::mt19937 random(1);
    std::uniform_real_distribution<double> u(0, 1);
    const Direction N(0, 0, 1);
    for (int i = 0; i < 10000; ++i) {
        const double theta_L = std::acos(u(random));
        const Direction L = direction(theta_L, 2 * pi * u(random));
        const double theta_V = std::acos(u(random));
        const Direction V = direction(theta_V, 2 * pi * u(random));
        const Angles a = angles_of(L, V);
        const double azimuth = std::abs(std::remainder(a.azimuth, pi));  // 0..90 degrees
        const Vec3<double> place = place_in_table(incidence(N, L, V));
        REQUIRE(std::abs(place.x - std::sqrt(a.half / right)) < 1e-7);
        REQUIRE(std::abs(place.y - a.difference / right) < 1e-7);
        REQUIRE(std::abs(place.z - azimuth / right) < 1e-4);  // ill-conditioned where L is near V
    }
}

TEST_CASE_TEMPLATE("the smallest theta_half are told apart", T, float, ALL_LANES) {
    double worst = 0;
    double worst_by_cosines = 0;
    for (int i = 0; i < 2000; ++i) {
        const double half = right * std::exp2(-4 - i / 200.0);  // from 5.6 to 0.005 degrees
        const Direction L = direction(0.7 + half, 0.3 * i);
        const Direction V = direction(0.7 - half, 0.3 * i + pi);
        const Vec3<float> l(L);
        const Vec3<float> v(V);
        const auto exact = place_in_table(
            incidence(Direction(0, 0, 1), Direction(l), Direction(v)));  // of the same directions
        const auto g = incidence(Vec3<T>(T(0.0F), T(0.0F), T(1.0F)), Vec3<T>(l), Vec3<T>(v));
        worst = worse(worst, std::abs(value(place_in_table(g).x) - exact.x));
        const auto by_cosines = place_in_table(Incidence<T>{g.NL, g.NV, g.LV});
        worst_by_cosines = worse(worst_by_cosines, std::abs(value(by_cosines.x) - exact.x));
    }
    CHECK(worst < 1e-5);
    CHECK(worst_by_cosines > 1e-3);  // why there is a fourth number
}

TEST_CASE("the directions of a cell are found in it again") {
    for (double half = 0.02; half < 1; half += 0.07) {
        for (double difference = 0.05; difference < 1; difference += 0.1) {
            for (double azimuth = 0.05; azimuth < 1; azimuth += 0.1) {
                const auto g =
                    incidence_of_half(half * half * right, difference * right, azimuth * right);
                const Vec3<double> place = place_in_table(g);
                CHECK(std::abs(place.x - half) < 1e-6);
                CHECK(std::abs(place.y - difference) < 1e-6);
                CHECK(std::abs(place.z - azimuth) < 1e-6);
            }
        }
    }
}

TEST_CASE("light and viewer change places: the same place, to the bit") {
    for (const Incidence<double>& g : pairs(1000)) {
        CHECK(place_in_table(g) == place_in_table(Incidence<double>{g.NV, g.NL, g.LV}));
    }
}

TEST_CASE("07.3 at the middle of a cell the table has what was measured") {
    const LambertPhong brdf = paint(20);
    const int size = 12;
    const MeasuredBrdf table = measured(brdf, size);
    for (int i = 0; i < size; ++i) {
        for (int j = 0; j < size; ++j) {
            for (int k = 0; k < 2 * size; ++k) {
                const double root = (i + 0.5) / size;
                const auto g = incidence_of_half(root * root * right, (j + 0.5) / size * right,
                                                 (k + 0.5) / size * right);
                if (g.NL > 0 && g.NV > 0) {
                    REQUIRE(length(table(g) - brdf(g)) < 1e-6);
                }
            }
        }
    }
}

TEST_CASE("07.3 between the cells it is linear") {
    auto table = std::make_shared<BrdfTable>(BrdfTable{4, 3, 2, {}, Rgb<float>(0.0F)});
    const auto plane = [](double x, double y, double z) { return 1 + x + 2 * y + 4 * z; };
    for (int cell = 0; cell < 24; ++cell) {
        const int row = cell / 6;
        const int column = cell / 2 % 3;
        const double value = plane((row + 0.5) / 4, (column + 0.5) / 3, (cell % 2 + 0.5) / 2);
        for (const double colour : {1.0, 2.0, 3.0}) {
            table->rgb.push_back(static_cast<float>(colour * value));
        }
    }
    const MeasuredBrdf brdf{table};
    for (const double x : {0.2, 0.5, 0.7}) {
        for (const double y : {0.2, 0.4, 0.8}) {
            for (const double z : {0.3, 0.5, 0.7}) {
                const auto g = incidence_of_half(x * x * right, y * right, z * right);
                const double expected = plane(x, y, z);
                CHECK(length(brdf(g) - Rgb<double>(1, 2, 3) * expected) < 1e-5);
            }
        }
    }
}

// Root mean square error of the radiance that a lamp makes, as a share of the radiance.
double error_of(int size) {
    const LambertPhong brdf = paint(120);
    const MeasuredBrdf table = measured(brdf, size);
    double error = 0;
    double all = 0;
    for (const Incidence<double>& g : pairs(50000)) {
        const double exact = brdf(g).g * g.NL;
        const double off = table(g).g * g.NL - exact;
        error += off * off;
        all += exact * exact;
    }
    return std::sqrt(error / all);
}

TEST_CASE("07.3 the larger the table, the smaller the error: the README's table") {
    CHECK(std::abs(error_of(4) / .235 - 1) < 0.04);
    CHECK(std::abs(error_of(10) / .039 - 1) < 0.04);
    CHECK(std::abs(error_of(25) / .0079 - 1) < 0.04);
    CHECK(std::abs(error_of(90) / .00062 - 1) < 0.04);
    CHECK(measured(paint(120), 25).table->rgb.size() * sizeof(float) == 187500);
}

TEST_CASE("a table is as reciprocal and as bright as what was measured") {
    const LambertPhong brdf = paint(20);
    const MeasuredBrdf table = measured(brdf, 40);
    for (const Incidence<double>& g : pairs(1000)) {
        CHECK(reciprocity_error(table, g) == Rgb<double>(0.0));
    }
    for (const double c : {1.0, 0.7, 0.3}) {
        const double exact = directional_albedo(brdf, c).g;
        CHECK(std::abs(directional_albedo(table, c).g / exact - 1) < 0.01);
    }
    const double mean = mean_albedo(brdf).g;
    CHECK(std::abs(double{table.ambient_albedo().g} / mean - 1) < 0.01);
    CHECK(std::abs(mean_albedo(LambertPhong{Rgb<float>(0.25F), Rgb<float>(0.0F), 1}).g -
                   0.25 * pi) < 1e-6);
}

TEST_CASE("what lies below the horizon is not measured, and filled from above it") {
    const MerlBrdf m = capture(paint(20), 10, 10, 20);
    int missing = 0;
    for (const Rgb<double>& value : m.values) {
        missing += value.g < 0 ? 1 : 0;
        CHECK((value.g >= 0 || value == Rgb<double>(-1.0)));
    }
    CHECK(missing > 100);
    CHECK(missing < 1000);
    const MeasuredBrdf table{table_of(m)};
    for (const float value : table.table->rgb) {
        REQUIRE(value >= 0.05F);  // its diffuse part at least
    }
}

TEST_CASE("cells without a value take that of the nearest smaller theta_difference, or the first") {
    const Rgb<double> none(-1);
    MerlBrdf m{1, 5, 2, {}};
    const double column[] = {-1, 3, -1, -1, 5};
    for (const double value : column) {
        m.values.emplace_back(value);
        m.values.push_back(none);  // its twin was not measured: the other one counts
    }
    const auto table = table_of(m);
    const float expected[] = {3, 3, 3, 3, 5};
    for (std::size_t j = 0; j < 5; ++j) {
        CHECK(table->rgb[3 * j] == expected[j]);
    }
    m.values.assign(10, none);
    CHECK(table_of(m)->rgb == std::vector<float>(15, 0.0F));  // nothing at all
}

TEST_CASE("what should be alike is averaged, and an odd count cannot be") {
    MerlBrdf m{1, 1, 4, {}};
    for (const double value : {1.0, 2.0, 4.0, 5.0}) {
        m.values.emplace_back(value);
    }
    const auto table = table_of(m);
    CHECK(table->azimuth == 2);
    CHECK(table->rgb[0] == 3);
    CHECK(table->rgb[3] == 3);
    m.azimuth = 3;
    m.values.pop_back();
    CHECK_THROWS_WITH_AS(table_of(m), doctest::Contains("even number of phi_difference, not 3"),
                         Error);
}

TEST_CASE_TEMPLATE("07 in every number type", T, float, ALL_LANES) {
    for (const int size : {1, 2, 30}) {
        const MeasuredBrdf table = measured(paint(20), size);
        for (const Incidence<double>& g : pairs(2000)) {
            const Incidence<float> f{float(g.NL), float(g.NV), float(g.LV)};
            const Rgb<double> exact =
                table(Incidence<double>{double{f.NL}, double{f.NV}, double{f.LV}});
            const Rgb<T> found = table(Incidence<T>{T(f.NL), T(f.NV), T(f.LV)});
            // Where L is near V or H near N, phi is off, but says little.
            REQUIRE(std::abs(value(found.g) - exact.g) < 2e-3);
        }
    }
}

TEST_CASE("07 every lane looks up its own place") {
    const MeasuredBrdf table = measured(paint(20), 30);
    constexpr int n = lanes_of<Float16>;
    float NL[n];
    for (int i = 0; i < n; ++i) {
        NL[i] = 0.1F + 0.05F * static_cast<float>(i);
    }
    const Rgb<Float16> all =
        table(Incidence<Float16>{load<Float16>(NL), Float16(0.5F), Float16(0.2F)});
    for (int i = 0; i < n; ++i) {
        const Rgb<float> one = table(Incidence<float>{NL[i], 0.5F, 0.2F});
        CHECK(lane(all.r, i) == doctest::Approx(one.r).epsilon(1e-4));
        CHECK(lane(all.g, i) == doctest::Approx(one.g).epsilon(1e-4));
        CHECK(lane(all.b, i) == doctest::Approx(one.b).epsilon(1e-4));
    }
}

TEST_CASE_TEMPLATE("07 at its ends", T, float, double, ALL_LANES) {
    const MeasuredBrdf table = measured(paint(20), 16);
    const auto at = [&](double NL, double NV, double LV) {
        return value(table(Incidence<T>{T(NL), T(NV), T(LV)}).g);
    };
    CHECK(at(1, 1, 1) == doctest::Approx(0.72).epsilon(0.02));  // L = V = N: diffuse and peak
    CHECK(at(0, 0, -1) > 0.1);                                  // grazing, across
    CHECK(at(1e-8, 1e-8, -1) > 0.1);
    CHECK(at(0.6, 0.6, 1) == doctest::Approx(0.12).epsilon(0.02));  // back to the light
    for (const double odd : {-1.0, -0.5, 0.0, 2.0, double{nan}, static_cast<double>(infinity)}) {
        for (const auto& f : {at(odd, 0.5, 0.5), at(0.5, odd, 0.5), at(0.5, 0.5, odd)}) {
            CHECK(f >= 0.1);
            CHECK(f <= 0.73);
        }
    }
}

}  // namespace
}  // namespace glint
