// A sphere of triangles against the sphere itself: depth and normal approach those at which the
// pixel's ray meets it, with the square of the triangles' size.
#include "framework/raster/plug.hpp"
#include "framework/geometry/shapes.hpp"
#include "tests/accuracy/line_fit.hpp"
#include "tests/unit/raster/drawing.hpp"
#include "tests/unit/raster/rays.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <optional>

namespace glint {
namespace {

struct ShowNormal {
    template <class T>
    struct Varyings {
        Vec3<T> normal;
    };
    static Varyings<float> vertex(const Vertex& v) { return {v.normal}; }
    template <Real T>
    Rgb<T> operator()(const Varyings<T>& in) const {
        return normalize(in.normal);
    }
};
constexpr ShowNormal show_normal;

const Camera camera{
    .eye = {1.2F, 1.6F, 2.4F}, .target = {0, 0, 0}, .fov_degrees = 40, .near = 1, .far = 6};

// Where a ray meets the unit sphere at the origin: its distance along the view direction.
std::optional<double> distance_to_sphere(const glm::dvec3& from, const glm::dvec3& direction) {
    const double a = dot(direction, direction);
    const double b = dot(from, direction);
    const double c = dot(from, from) - 1;
    const double discriminant = b * b - a * c;
    if (discriminant < 0) {
        return std::nullopt;
    }
    return (-b - std::sqrt(discriminant)) / a;
}

struct Errors {
    double distance = 0, normal = 0;
    int pixels = 0;
};

// The largest errors, where the surface is not seen from its edge.
Errors errors_of(const Mesh& mesh, const Settings& settings) {
    constexpr int size = 90;
    const View view{clip_from_world(camera, 1), size, size};
    const Rays rays(camera, size, size);
    const Drawn d = draw(mesh, view, plug(show_normal), settings);
    Errors e;
    for (int y = 0; y < size; ++y) {
        for (int x = 0; x < size; ++x) {
            const glm::dvec3 direction = rays.direction(x + 0.5, y + 0.5);
            const auto distance = distance_to_sphere(rays.origin, direction);
            if (!distance) {
                continue;
            }
            const glm::dvec3 normal = rays.origin + *distance * direction;
            if (-dot(normal, normalize(direction)) < 0.4) {
                continue;
            }
            ++e.pixels;
            const double drawn = distance_of_depth(camera, double{d.depth(x, y)});
            e.distance = std::max(e.distance, std::abs(drawn - *distance));
            e.normal = std::max(e.normal, length(glm::dvec3(d.linear(x, y)) - normal));
        }
    }
    return e;
}

TEST_CASE("depth and normal of a sphere converge with the square of the triangles' size") {
    for (const Settings& settings : both_rasterizers()) {
        CAPTURE(words(settings));
        LineFit distance;
        LineFit normal;
        for (const int rings : {8, 12, 18, 27, 40, 60, 90, 135}) {
            const Errors e = errors_of(sphere(1, 2 * rings, rings), settings);
            CHECK(e.pixels > 2000);
            distance.add(std::log(1.0 / rings), std::log(e.distance));
            normal.add(std::log(1.0 / rings), std::log(e.normal));
        }
        CHECK(distance.slope() > 1.9);
        CHECK(distance.slope() < 2.1);
        CHECK(normal.slope() > 1.9);
        CHECK(normal.slope() < 2.1);
        // A chord of angle h leaves its arc by h^2 / 8: here by 2 (pi / 135)^2 / 8 / 0.4 or less.
        CHECK(errors_of(sphere(1, 270, 135), settings).distance < 3.4e-4);
    }
}

}  // namespace
}  // namespace glint
