#include "framework/scene/light.hpp"

#include "framework/math/lanes.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <limits>
#include <vector>

namespace glint {
namespace {

struct Arrived {
    glm::dvec3 direction, irradiance;
};

template <Real T>
double of_lane(const T& x, int lane) {
    if constexpr (is_lanes<T>) {
        float values[lanes_of<T>];
        store(values, x);
        return values[lane];
    } else {
        return x;
    }
}

template <Real T>
glm::dvec3 of_lane(const Vec3<T>& v, int lane) {
    return {of_lane(v.x, lane), of_lane(v.y, lane), of_lane(v.z, lane)};
}

// Different points in the lanes of one number; all that arrives at each.
template <Real T>
std::vector<std::vector<Arrived>> arriving(const Lighting& lighting,
                                           const std::vector<glm::vec3>& points) {
    std::vector<std::vector<Arrived>> all(points.size());
    for (std::size_t i = 0; i < points.size(); i += lanes_of<T>) {
        const auto count = std::min<std::size_t>(lanes_of<T>, points.size() - i);
        const auto component = [&](int k) {
            if constexpr (is_lanes<T>) {
                float values[lanes_of<T>] = {};
                for (std::size_t lane = 0; lane < count; ++lane) {
                    values[lane] = points[i + lane][k];
                }
                return load<T>(values);
            } else {
                return T(points[i][k]);
            }
        };
        const Vec3<T> position(component(0), component(1), component(2));
        for_each_light(lighting, position, [&](const Incident<T>& light) {
            for (std::size_t lane = 0; lane < count; ++lane) {
                const int n = static_cast<int>(lane);
                all[i + lane].push_back(
                    {of_lane(light.direction, n), of_lane(light.irradiance, n)});
            }
        });
    }
    return all;
}

#define ALL_NUMBERS float, double, Float<4>, Float<max_lanes>

TEST_CASE_TEMPLATE("a point light falls off with the square of the distance", T, ALL_NUMBERS) {
    const Lighting lighting{
        .directional = {}, .point = {{{1, 2, 3}, {8, 4, 2}}}, .ambient = Rgb<float>(0)};
    std::vector<glm::vec3> points;
    for (float d = 0.01F; d < 1e4F; d *= 1.7F) {
        points.push_back(glm::vec3(1, 2, 3) - d * glm::vec3(2, -1, 2) / 3.0F);
    }
    const auto all = arriving<T>(lighting, points);
    for (std::size_t i = 0; i < points.size(); ++i) {
        CAPTURE(i);
        REQUIRE(all[i].size() == 1);
        const glm::dvec3 way = glm::dvec3(1, 2, 3) - glm::dvec3(points[i]);
        const double square = dot(way, way);
        const Arrived& a = all[i][0];
        CHECK(length(a.direction - way / std::sqrt(square)) < 1e-6);
        CHECK(length(a.irradiance * square - glm::dvec3(8, 4, 2)) < 1e-5);
    }
}

TEST_CASE_TEMPLATE("in the place of a light nothing arrives, and nothing is NaN", T, ALL_NUMBERS) {
    const Lighting lighting{
        .directional = {}, .point = {{{1, 2, 3}, {8, 4, 2}}}, .ambient = Rgb<float>(0)};
    // Lanes beside it see the light as always.
    const std::vector<glm::vec3> points{
        {1, 2, 3}, {1, 2, 4}, {1, 2, 3.00001F}, {1, 2, 3}, {1, 2, 3e20F}};
    const auto all = arriving<T>(lighting, points);
    for (const auto& at : all) {
        REQUIRE(at.size() == 1);
        for (int k = 0; k < 3; ++k) {
            CHECK(std::isfinite(at[0].direction[k]));
            CHECK(std::isfinite(at[0].irradiance[k]));
        }
    }
    CHECK(all[0][0].direction == glm::dvec3(0));
    CHECK(all[3][0].direction == glm::dvec3(0));
    CHECK(all[1][0].direction == glm::dvec3(0, 0, -1));
    CHECK(all[1][0].irradiance == glm::dvec3(8, 4, 2));
    CHECK(all[2][0].direction.z == doctest::Approx(-1));
    CHECK(all[2][0].irradiance.x <= 1.0001 * 8 / (nearest_point_light * nearest_point_light));
    CHECK(all[4][0].irradiance.x <= 1e-38);
}

TEST_CASE_TEMPLATE("a directional light is the same everywhere", T, ALL_NUMBERS) {
    const Lighting lighting{
        .directional = {{{0, 0.6F, 0.8F}, {1, 2, 3}}}, .point = {}, .ambient = Rgb<float>(0)};
    for (const auto& at : arriving<T>(lighting, {{0, 0, 0}, {1e6F, -3, 2}, {5, 5, 5}})) {
        REQUIRE(at.size() == 1);
        CHECK(at[0].direction == glm::dvec3(glm::vec3(0, 0.6F, 0.8F)));
        CHECK(at[0].irradiance == glm::dvec3(1, 2, 3));
    }
}

TEST_CASE_TEMPLATE("every light comes once, in order, directional ones first", T, ALL_NUMBERS) {
    Lighting lighting;
    for (int i = 0; i < 5; ++i) {
        const auto n = static_cast<float>(i);
        lighting.directional.push_back({{0, 0, 1}, Rgb<float>(n)});
        lighting.point.push_back({{0, 1, 0}, Rgb<float>(10 + n)});
    }
    const auto all = arriving<T>(lighting, {{0, 0, 0}});
    REQUIRE(all[0].size() == 10);
    for (std::size_t i = 0; i < 5; ++i) {
        CHECK(all[0][i].irradiance.x == static_cast<double>(i));
        CHECK(all[0][5 + i].irradiance.x == static_cast<double>(10 + i));
    }
    CHECK(arriving<T>(Lighting{}, {{0, 0, 0}})[0].empty());
}

}  // namespace
}  // namespace glint
