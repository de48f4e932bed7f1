#include "lessons/00_hello_shader/hello_shader.hpp"
#include "tests/unit/lessons/lane_value.hpp"

#include <doctest/doctest.h>

namespace glint {
namespace {

template <class T>
Rgb<double> colour(const glm::vec3& normal, float brightness = 1) {
    const Rgb<T> c = HelloShader{brightness}(HelloShader::Varyings<T>{Vec3<T>(normal)});
    return {value(c.r), value(c.g), value(c.b)};
}

TEST_CASE_TEMPLATE("00 right is red, up green, towards the eye blue", T, float, double, ALL_LANES) {
    CHECK(colour<T>({1, 0, 0}) == glm::dvec3(1, 0.5, 0.5));
    CHECK(colour<T>({0, -1, 0}) == glm::dvec3(0.5, 0, 0.5));
    CHECK(colour<T>({0, 0, 1}) == glm::dvec3(0.5, 0.5, 1));
    CHECK(colour<T>({0, 0, 1}, 0.5F) == glm::dvec3(0.25, 0.25, 0.5));
    // Interpolated normals are too short; their length is not shown.
    CHECK(length(colour<T>({0, 0.3F, 0.4F}) - glm::dvec3(0.5, 0.8, 0.9)) < 1e-6);
    for (const glm::vec3 normal : {glm::vec3(0), glm::vec3(nan), glm::vec3(0, 0, infinity)}) {
        CHECK(colour<T>(normal) == glm::dvec3(0.5));
    }
}

}  // namespace
}  // namespace glint
