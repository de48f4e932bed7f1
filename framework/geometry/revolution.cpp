// Sphere, torus and free profiles: all are a profile turned round the y axis.
#include "framework/geometry/shapes.hpp"
#include "framework/geometry/surface_grid.hpp"
#include "framework/math/error.hpp"

#include <cmath>
#include <string>

namespace glint {
namespace {

struct ProfilePoint {
    double radius, height;
    glm::dvec2 normal;  // radial, upwards
    double v;
};

// A piece of profile without sharp edges; it may touch the axis at its ends.
void append_revolved(Mesh& mesh, std::span<const ProfilePoint> strip, int segments) {
    const Grid grid{.columns = segments,
                    .rows = static_cast<int>(strip.size()) - 1,
                    .first_row_is_point = strip.front().radius == 0.0,
                    .last_row_is_point = strip.back().radius == 0.0};
    append_grid(mesh, grid, [&](double column, double row) {
        const ProfilePoint& p = strip[static_cast<std::size_t>(row)];
        const glm::dvec2 angle = turn(column, segments);
        const glm::dvec3 outwards(-angle.y, 0.0, -angle.x);  // u = 0 is at the back
        const glm::dvec3 up(0.0, 1.0, 0.0);
        return SurfacePoint{.position = p.radius * outwards + p.height * up,
                            .normal = p.normal.x * outwards + p.normal.y * up,
                            .uv = {column / segments, p.v}};
    });
}

glm::dvec2 right_of(const glm::dvec2& direction) {
    return normalize(glm::dvec2(direction.y, -direction.x));
}

void check_profile(std::span<const glm::vec2> points) {
    check_count("surface of revolution: profile points", static_cast<int>(points.size()), 2,
                max_steps);
    for (std::size_t i = 0; i < points.size(); ++i) {
        const glm::vec2 p = points[i];
        if (!(p.x >= 0.0F && p.x <= 1e6F && std::abs(p.y) <= 1e6F)) {
            throw Error("surface of revolution: point " + std::to_string(i) +
                        " must have a radius of 0 to 1e6 and a height of -1e6 to 1e6");
        }
    }
}

[[noreturn]] void fail_at(const char* what, std::size_t i) {
    throw Error("surface of revolution: " + std::string(what) + " " + std::to_string(i));
}

// A cubic Bezier curve in the plane of the profile.
struct Curve {
    glm::dvec2 a, b, c, d;

    glm::dvec2 point(double t) const {
        const double s = 1.0 - t;
        return s * s * s * a + 3.0 * s * s * t * b + 3.0 * s * t * t * c + t * t * t * d;
    }
    glm::dvec2 derivative(double t) const {
        const double s = 1.0 - t;
        return s * s * (b - a) + 2.0 * s * t * (c - b) + t * t * (d - c);
    }
    // The way the curve goes; where control points coincide at an end, its limit there.
    glm::dvec2 direction(double t) const {
        if (t == 0.0 && a == b) {
            return a == c ? d - a : c - a;
        }
        if (t == 1.0 && c == d) {
            return b == d ? d - a : d - b;
        }
        return derivative(t);
    }
};

std::vector<ProfilePoint> sample(const Curve& curve, int steps, double v, double v_size) {
    std::vector<ProfilePoint> strip;
    for (int i = 0; i <= steps; ++i) {
        const double t = static_cast<double>(i) / steps;
        const glm::dvec2 p = curve.point(t);
        strip.push_back({p.x, p.y, right_of(curve.direction(t)), v + t * v_size});
    }
    return strip;
}

// A curve must not lie on the axis, and every sample needs a normal.
void check_strip(std::span<const ProfilePoint> strip, std::size_t curve) {
    bool has_normals = true;
    for (const ProfilePoint& p : strip) {
        has_normals = has_normals && std::isfinite(p.normal.x);
    }
    if (!has_normals || strip[1].radius == 0.0) {
        fail_at("no surface or no normal along curve", curve);
    }
}

}  // namespace

Mesh sphere(float radius, int segments, int rings) {
    check_length("sphere: radius", radius);
    check_count("sphere: segments", segments, 3, max_steps);
    check_count("sphere: rings", rings, 2, max_steps);
    std::vector<ProfilePoint> profile;
    for (int i = 0; i <= rings; ++i) {
        const glm::dvec2 angle = turn(i, 2 * rings);  // from the lower pole
        const glm::dvec2 normal(angle.y, -angle.x);
        profile.push_back(
            {radius * normal.x, radius * normal.y, normal, static_cast<double>(i) / rings});
    }
    Mesh mesh;
    append_revolved(mesh, profile, segments);
    return mesh;
}

Mesh torus(float major, float minor, int segments, int sides) {
    check_length("torus: major", major);
    check_length("torus: minor", minor);
    check_count("torus: segments", segments, 3, max_steps);
    check_count("torus: sides", sides, 3, max_steps);
    if (minor >= major) {
        throw Error("torus: minor must be less than major");
    }
    std::vector<ProfilePoint> profile;
    for (int i = 0; i <= sides; ++i) {
        const glm::dvec2 normal = turn(i, sides);
        profile.push_back(
            {major + minor * normal.x, minor * normal.y, normal, static_cast<double>(i) / sides});
    }
    Mesh mesh;
    append_revolved(mesh, profile, segments);
    return mesh;
}

Mesh surface_of_revolution(std::span<const glm::vec2> points, int segments) {
    check_count("surface of revolution: segments", segments, 3, max_steps);
    check_profile(points);
    const auto stretches = static_cast<double>(points.size() - 1);
    Mesh mesh;
    for (std::size_t i = 0; i + 1 < points.size(); ++i) {
        const glm::dvec2 a(points[i]);
        const glm::dvec2 b(points[i + 1]);
        if (a == b || (a.x == 0.0 && b.x == 0.0)) {
            fail_at("no surface between the next point and point", i);
        }
        const glm::dvec2 normal = right_of(b - a);
        const auto v = static_cast<double>(i);
        const ProfilePoint strip[] = {{a.x, a.y, normal, v / stretches},
                                      {b.x, b.y, normal, (v + 1.0) / stretches}};
        append_revolved(mesh, strip, segments);
    }
    return mesh;
}

Mesh surface_of_revolution_bezier(std::span<const glm::vec2> control, int steps, int segments) {
    check_count("surface of revolution: segments", segments, 3, max_steps);
    check_count("surface of revolution: steps", steps, 2, max_steps);
    if (control.size() < 4 || control.size() % 3 != 1) {
        throw Error("surface of revolution: k Bezier curves have 3 k + 1 control points, not " +
                    std::to_string(control.size()));
    }
    check_profile(control);
    const std::size_t curves = control.size() / 3;
    const double v_size = 1.0 / static_cast<double>(curves);
    Mesh mesh;
    for (std::size_t k = 0; k < curves; ++k) {
        const auto c = control.subspan(3 * k, 4);
        const Curve curve{glm::dvec2(c[0]), glm::dvec2(c[1]), glm::dvec2(c[2]), glm::dvec2(c[3])};
        const auto strip = sample(curve, steps, static_cast<double>(k) * v_size, v_size);
        check_strip(strip, k);
        append_revolved(mesh, strip, segments);
    }
    return mesh;
}

}  // namespace glint
