#include "lessons/05_reciprocity/reciprocity.hpp"
#include "lessons/06_energy/energy.hpp"
#include "lessons/06_energy/furnace.hpp"
#include "lessons/06_energy/plot.hpp"
#include "tests/unit/lessons/lane_value.hpp"

#include <doctest/doctest.h>

namespace glint {
namespace {

LambertPhong matt(double Cd) {
    return {Rgb<float>(static_cast<float>(Cd)), Rgb<float>(0.0F), 1};
}

double cosine_of(double theta) {
    return std::max(std::cos(theta), 1e-9);
}

TEST_CASE("06.1 the sum is the integral that the instrument measures") {
    for (const double theta : {0.0, 0.5, 1.0, 1.4}) {
        CAPTURE(theta);
        CHECK(std::abs(albedo(matt(1), theta, 64) - pi) < 4e-4);
        for (const float n : {0.5F, 3.0F, 30.0F}) {
            const double exact = directional_albedo(PhongLobe{n}, cosine_of(theta)).g;
            CHECK(std::abs(albedo(PhongLobe{n}, theta, 128) - exact) < 2e-3);
        }
    }
}

TEST_CASE("06.1 twice as many patches each way, a quarter of the error") {
    const auto error = [](int rings) { return albedo(PhongLobe{4}, 0, rings) - 2 * pi / 6; };
    for (const int rings : {8, 16, 32}) {
        CHECK(error(rings) / error(2 * rings) == doctest::Approx(4).epsilon(0.02));
    }
}

TEST_CASE("06.2 the lobe's albedo along the normal: the README's table") {
    constexpr double table[][2] = {{0, 3.142},   {1, 2.094},   {2, 1.571},    {4, 1.047},
                                   {5, .898},    {10, .524},   {20, .286},    {50, .121},
                                   {100, .0616}, {500, .0125}, {1000, .00627}};
    for (const auto& [n, expected] : table) {
        CHECK(std::abs(phong_albedo_along_normal(n) / expected - 1) < 2e-3);
        const PhongLobe lobe{static_cast<float>(n)};
        CHECK(std::abs(directional_albedo(lobe, 1).g - phong_albedo_along_normal(n)) < 1e-7);
        const LambertPhong sum{Rgb<float>(1.0F), Rgb<float>(1.0F), static_cast<float>(n)};
        CHECK(std::abs(directional_albedo(sum, 1).g - phong_albedo_along_normal(n) - pi) < 1e-6);
    }
    for (const double n : {0.5, 1e6}) {  // fractions and needles
        const PhongLobe lobe{static_cast<float>(n)};
        CHECK(directional_albedo(lobe, 1).g ==
              doctest::Approx(phong_albedo_along_normal(n)).epsilon(1e-6));
    }
}

TEST_CASE("06.2 elsewhere it is smaller: the README's row") {
    constexpr double degrees[] = {0, 30, 45, 60, 75, 85};
    constexpr double expected[] = {1.047, .908, .747, .552, .358, .245};
    for (int i = 0; i < 6; ++i) {
        CHECK(std::abs(directional_albedo(PhongLobe{4}, cos_of_degrees(degrees[i])).g -
                       expected[i]) < 6e-4);
    }
}

TEST_CASE("06.3 who conserves energy") {
    CHECK(conserves_energy(matt(1 / pi), 64));
    CHECK(!conserves_energy(matt(0.32), 64));
    CHECK(!conserves_energy(matt(1), 64));
    CHECK(!conserves_energy(PhongLobe{4.2F}, 64));  // the limit is n = 2 pi - 2 = 4.283
    CHECK(conserves_energy(PhongLobe{4.4F}, 64));
    CHECK(conserves_energy(PhongLobe{1000}, 64));
    CHECK(!conserves_energy(LambertPhong{Rgb<float>(0.3F), Rgb<float>(1.0F), 50}, 64));
}

TEST_CASE("06.3 lesson 1's highlight passes along the normal and fails aslant") {
    const ClassicPhong classic{10};
    CHECK(std::abs(directional_albedo(classic, 1).g - .524) < 5e-4);
    CHECK(std::abs(directional_albedo(classic, cos_of_degrees(89)).g - 3.96) < 5e-3);
    CHECK(!conserves_energy(classic, 64));
}

TEST_CASE("what a viewer sees in the furnace is the albedo, for what is reciprocal") {
    for (const double c : {1.0, 0.7, 0.2, 0.01}) {
        for (const float n : {1.0F, 10.0F, 1000.0F}) {
            const auto by = [&](Fixed fixed) {
                return directional_albedo(PhongLobe{n}, c, fixed).g;
            };
            CHECK(std::abs(by(Fixed::light) - by(Fixed::view)) < 1e-9);
        }
        CHECK(directional_albedo(ClassicPhong{10}, c, Fixed::view).g < .572);  // hides its fault
    }
}

TEST_CASE("the curve is the measured one, for light or viewer fixed") {
    const LambertPhong brdf{Rgb<float>(0.1F), Rgb<float>(1.0F), 4};
    for (const Fixed fixed : {Fixed::light, Fixed::view}) {
        const AlbedoCurve curve(brdf, fixed);
        for (const double c : {0.01, 0.1, 0.4, 0.77, 1.0}) {
            CHECK(std::abs(curve(c) - directional_albedo(brdf, c, fixed).g) < 1e-3);
        }
    }
}

TEST_CASE("above 1 a share has the warning colour, at 1 it has not") {
    const Rgb<double> warning = false_colour(2.0);
    CHECK(colour_of_share(1.0, 40) == false_colour(1.0));
    CHECK(colour_of_share(1.01, 1000) == warning);
    CHECK(colour_of_share(0.25, 40) == false_colour(0.25));
    CHECK(colour_of_share(1.01, 40) != warning);
    CHECK(colour_of_share(1.03, 40) == warning);
}

template <class T>
Rgb<double> colour(const Furnace& furnace, const glm::vec3& normal) {
    const auto in = Furnace::Varyings<T>{Vec3<T>(T(0.0F)), Vec3<T>(normal)};
    const Rgb<T> c = furnace(in);
    return {value(c.r), value(c.g), value(c.b)};
}

TEST_CASE_TEMPLATE("06 the furnace in every number type", T, float, double, ALL_LANES) {
    const Furnace invisible{AlbedoCurve(matt(1 / pi), Fixed::view), {0, 0, 5}};
    const Furnace too_bright{AlbedoCurve(matt(0.4), Fixed::view), {0, 0, 5}};
    const Furnace lobe{AlbedoCurve(PhongLobe{10}, Fixed::view), {0, 0, 5}};
    for (const double degrees : {0.0, 40.0, 80.0, 90.0, 120.0}) {
        const glm::vec3 N(std::sin(degrees * pi / 180), 0, cos_of_degrees(degrees));
        CHECK(length(colour<T>(invisible, N) - false_colour(1.0)) < 2e-4);
        CHECK(length(colour<T>(too_bright, N) - false_colour(2.0)) < 1e-6);
        CHECK(length(colour<T>(lobe, N) - colour<double>(lobe, N)) < 2e-5);
    }
    for (const glm::vec3 none : {glm::vec3(0), glm::vec3(nan), glm::vec3(infinity)}) {
        CHECK(length(colour<T>(lobe, none) - colour<double>(lobe, {1, 0, 0})) < 2e-5);  // grazing
    }
}

TEST_CASE("a line of the plot is as wide as it says, and goes where its points are") {
    CHECK(plot::place(0, 0) == glm::vec2(30, 30));
    CHECK(plot::place(90, 3.3) == glm::vec2(460, 520));
    Mesh mesh;
    plot::add_line(mesh, {{0, 0}, {10, 0}, {10, 10}}, {0.0F, 0.5F, 1.0F}, 2, 0);
    REQUIRE(mesh.positions.size() == 6);
    CHECK(mesh.triangles.size() == 4);
    CHECK(mesh.materials.size() == 4);
    CHECK(length(mesh.positions[0] - glm::vec3(0, 1, 0.5F)) < 1e-6F);
    CHECK(length(mesh.positions[1] - glm::vec3(0, -1, 0.5F)) < 1e-6F);
    CHECK(mesh.uvs[2].x == 0.5F);
    for (const glm::uvec3& t : mesh.triangles) {  // all of them face us
        const glm::vec3 a = mesh.positions[t.x];
        CHECK(cross(mesh.positions[t.y] - a, mesh.positions[t.z] - a).z > 0);
    }
}

}  // namespace
}  // namespace glint
