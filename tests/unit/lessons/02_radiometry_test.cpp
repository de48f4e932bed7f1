#include "lessons/02_radiometry/radiometry.hpp"
#include "framework/measure/quadrature.hpp"
#include "tests/unit/lessons/lane_value.hpp"

#include <doctest/doctest.h>

namespace glint {
namespace {

double one(double, double) {
    return 1;
}

TEST_CASE("02 angles are lengths and areas over the radius") {
    CHECK(plane_angle(2 * pi * 3, 3) == doctest::Approx(2 * pi));      // a circle
    CHECK(solid_angle(4 * pi * 3 * 3, 3) == doctest::Approx(4 * pi));  // a sphere
    CHECK(solid_angle(1, 1e-3) == doctest::Approx(1e6));
}

TEST_CASE("02.1 a patch is as large as its circle of latitude is long") {
    const double d = 1e-3;
    for (const double theta : {0.001, 0.1, 0.8, 1.5, pi / 2, 3.0}) {
        // The zone between two circles of latitude on the unit sphere has area 2 pi times its
        // height.
        const double zone = 2 * pi * (std::cos(theta - d / 2) - std::cos(theta + d / 2));
        CHECK(differential_solid_angle(theta, d, 2 * pi) == doctest::Approx(zone).epsilon(1e-7));
    }
    CHECK(differential_solid_angle(0, d, d) == 0);
}

// The rule of midpoints has an error in closed form here.
TEST_CASE("02.1 the hemisphere is 2 pi steradians, the more exactly the more samples") {
    for (const int rings : {1, 2, 3, 8, 64, 256}) {
        const double step = pi / 2 / rings;
        CHECK(hemisphere_integral(rings, one) ==
              doctest::Approx(2 * pi * (step / 2) / std::sin(step / 2)).epsilon(1e-12));
    }
}

TEST_CASE("02.2 constant radiance makes irradiance pi, the more exactly the more samples") {
    for (const int rings : {1, 2, 3, 8, 64, 256}) {
        const double step = pi / 2 / rings;
        CHECK(irradiance(rings, one) == doctest::Approx(pi * step / std::sin(step)).epsilon(1e-12));
    }
}

TEST_CASE("02 the table of the text: share of error by number of samples") {
    struct Row {
        int rings, samples;
        double angle, irradiance;
    };
    constexpr Row rows[] = {{1, 4, .111, .571},
                            {2, 16, .0262, .111},
                            {4, 64, .00646, .0262},
                            {8, 256, .00161, .00646},
                            {16, 1024, .000402, .00161},
                            {32, 4096, .000100, .000402},
                            {64, 16384, .0000251, .000100}};
    for (const Row& row : rows) {
        CAPTURE(row.rings);
        int samples = 0;
        const double angle = hemisphere_integral(row.rings, [&](double, double) {
            ++samples;
            return 1.0;
        });
        CHECK(samples == row.samples);
        CHECK(angle / (2 * pi) - 1 == doctest::Approx(row.angle).epsilon(0.005));
        CHECK(irradiance(row.rings, one) / pi - 1 ==
              doctest::Approx(row.irradiance).epsilon(0.005));
    }
    // Were patches squares, 1/sin(theta) would be integrated: pi^2, whatever the number.
    for (const int rings : {1, 8, 64}) {
        const double squares =
            hemisphere_integral(rings, [](double theta, double) { return 1 / std::sin(theta); });
        CHECK(squares == doctest::Approx(pi * pi));
        CHECK(squares / (2 * pi) - 1 == doctest::Approx(0.571).epsilon(1e-3));
    }
}

TEST_CASE("02.2 irradiance by radiance that is not constant") {
    const auto up = [](double theta, double) { return std::cos(theta); };
    const auto sideways = [](double, double phi) { return 1 + std::cos(phi); };
    CHECK(irradiance(256, up) == doctest::Approx(2 * pi / 3).epsilon(1e-4));
    CHECK(irradiance(256, sideways) == doctest::Approx(pi).epsilon(1e-4));
}

TEST_CASE("02 a disk seen from its axis: 2 pi (1 - cos) steradians, pi sin^2 of irradiance") {
    const double edge = pi / 3;  // where a ring ends, so that no patch is cut
    const auto disk = [&](double theta, double) { return theta < edge ? 1.0 : 0.0; };
    CHECK(hemisphere_integral(300, disk) ==
          doctest::Approx(2 * pi * (1 - std::cos(edge))).epsilon(1e-5));
    const double E = irradiance(300, disk);
    CHECK(E == doctest::Approx(pi * std::sin(edge) * std::sin(edge)).epsilon(1e-5));
    const double below = 1 / std::tan(edge);
    CHECK(pi * irradiance_of_disk(1.0, below, 0.0).y == doctest::Approx(E).epsilon(1e-5));
}

// What the disk's patches send to a receiver of normal N at a point below it and aside.
double by_quadrature(double radius, double below, double aside, const glm::dvec3& N) {
    static const Quadrature rule = gauss_legendre(48);
    return integrate(rule, 0, radius, [&](double r) {
        return 2 * integrate(rule, 0, pi, [&](double phi) {
                   const glm::dvec3 across(r * std::cos(phi) - aside, below, r * std::sin(phi));
                   const glm::dvec3 mirrored(across.x, across.y, -across.z);  // the other half
                   const double square = dot(across, across);
                   const double facing = 0.5 * (dot(N, across) + dot(N, mirrored));
                   return r * facing * below / (square * square) / pi;
               });
    });
}

TEST_CASE("02.3 irradiance of a disk by quadrature over its area") {
    for (const double radius : {0.2, 1.0, 3.0}) {
        for (const double below : {0.7, 2.0, 10.0}) {
            for (const double aside : {0.0, 0.5, 1.0, 2.9, 8.0}) {
                CAPTURE(radius);
                CAPTURE(below);
                CAPTURE(aside);
                const glm::dvec2 E = irradiance_of_disk(radius, below, aside);
                CHECK(
                    E.y ==
                    doctest::Approx(by_quadrature(radius, below, aside, {0, 1, 0})).epsilon(1e-6));
                const double inward = by_quadrature(radius, below, aside, {-1, 0, 0});
                CHECK(std::abs(E.x - inward) <= 1e-6 * E.y + 1e-6 * std::abs(inward));
                // Tilted, with all of the disk above the horizon.
                const glm::dvec3 N = normalize(glm::dvec3(-0.2, 1, 0.1));
                const double tilted = by_quadrature(radius, below, aside, N);
                CHECK(E.x * 0.2 / std::sqrt(1.05) + E.y / std::sqrt(1.05) ==
                      doctest::Approx(tilted).epsilon(1e-6));
            }
        }
    }
}

TEST_CASE("02.3 it is sin^2 of half the angle between the rim's nearest and farthest point") {
    for (const double below : {1e-3, 0.3, 1.0, 20.0}) {
        for (const double aside : {0.0, 0.3, 0.999, 1.0, 1.5, 30.0}) {
            const double gamma = std::atan2(aside + 1, below) - std::atan2(aside - 1, below);
            const double sine = std::sin(gamma / 2);
            CHECK(irradiance_of_disk(1.0, below, aside).y ==
                  doctest::Approx(sine * sine).epsilon(1e-9));
        }
    }
}

TEST_CASE("02.3 on the axis: 1/(1 + h^2), and far away the inverse square") {
    CHECK(irradiance_of_disk(1.0, 0.5, 0.0).y == doctest::Approx(0.8));
    CHECK(std::abs(irradiance_of_disk(1.0, 1.5, 0.0).y - 0.308) < 5e-4);
    CHECK(std::abs(irradiance_of_disk(1.0, 4.0, 0.0).y - 0.0588) < 5e-5);
    for (const double h : {10.0, 100.0, 1e6}) {
        const double ratio = irradiance_of_disk(1.0, h, 0.0).y * h * h;
        CHECK(ratio == doctest::Approx(1 - 1 / (h * h)).epsilon(1.1 / (h * h * h * h) + 1e-15));
    }
}

TEST_CASE_TEMPLATE("02.3 in every number type", T, float, ALL_LANES) {
    for (const float radius : {1e-3F, 1.0F, 50.0F}) {
        for (const float below : {1e-8F, 1e-3F, 0.5F, 4.0F, 1e3F, 1e6F}) {
            for (const float aside : {0.0F, 1e-4F, 0.5F, 0.999F, 1.0F, 1.001F, 7.0F, 1e6F}) {
                const Vec2<T> E = irradiance_of_disk(T(radius), T(below), T(aside));
                const glm::dvec2 exact =
                    irradiance_of_disk(double{radius}, double{below}, double{aside});
                CAPTURE(radius);
                CAPTURE(below);
                CAPTURE(aside);
                CHECK(std::abs(value(E.x) - exact.x) <= 2e-6 * exact.x + 1e-37);
                CHECK(std::abs(value(E.y) - exact.y) <= 2e-6 * exact.y + 1e-37);
            }
        }
    }
}

TEST_CASE_TEMPLATE("02.3 at the ends", T, float, double, ALL_LANES) {
    const auto E = [](float radius, float below, float aside) {
        const Vec2<T> e = irradiance_of_disk(T(radius), T(below), T(aside));
        return glm::dvec2(value(e.x), value(e.y));
    };
    for (const float none : {0.0F, -1e-8F, -1.0F, -infinity, nan}) {
        CHECK(E(1, none, 0) == glm::dvec2(0));
        CHECK(E(1, none, 1) == glm::dvec2(0));
        CHECK(E(1, none, 5) == glm::dvec2(0));
    }
    CHECK(E(1, 1e-8F, 0).y == doctest::Approx(1));  // touching: all of the hemisphere
    CHECK(E(1, 1e-8F, 0.5F).y == doctest::Approx(1));
    CHECK(E(1, 1e-8F, 1).y == doctest::Approx(0.5));  // under the rim: half of it
    CHECK(E(1, 1e-8F, 2).y < 1e-15);
    CHECK(E(0, 1, 0) == glm::dvec2(0));
    CHECK(E(1e6F, 1, 0).y == doctest::Approx(1));
}

}  // namespace
}  // namespace glint
