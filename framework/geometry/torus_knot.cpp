#include "framework/geometry/shapes.hpp"
#include "framework/geometry/surface_grid.hpp"
#include "framework/math/error.hpp"

#include <numeric>

namespace glint {
namespace {

// The curve at a step and two unit vectors across it. The torus that it winds on gives the frame:
// its normal is perpendicular to every curve on it and comes back to itself, Frenet's may flip.
struct Frame {
    glm::dvec3 centre, normal, binormal;
};

Frame frame_at(const TorusKnot& knot, int step, int segments) {
    const glm::dvec2 a = turn(knot.p * step % segments, segments);
    const glm::dvec2 b = turn(knot.q * step % segments, segments);
    const glm::dvec3 outwards(-a.y, 0.0, -a.x);
    const glm::dvec3 onwards(-a.x, 0.0, a.y);  // d outwards / d angle
    const glm::dvec3 up(0.0, 1.0, 0.0);
    const double distance = knot.major + knot.minor * b.x;
    const glm::dvec3 normal = b.x * outwards + b.y * up;
    const glm::dvec3 tangent = knot.p * distance * onwards + static_cast<double>(knot.q) *
                                                                 static_cast<double>(knot.minor) *
                                                                 (b.x * up - b.y * outwards);
    return {.centre = distance * outwards + knot.minor * b.y * up,
            .normal = normal,
            .binormal = cross(normalize(tangent), normal)};
}

void check_knot(const TorusKnot& knot) {
    check_count("torus knot: p", knot.p, 1, 64);
    check_count("torus knot: q", knot.q, 1, 64);
    check_length("torus knot: major", knot.major);
    check_length("torus knot: minor", knot.minor);
    check_length("torus knot: tube", knot.tube);
    if (std::gcd(knot.p, knot.q) != 1) {
        throw Error("torus knot: p and q must have no common divisor");
    }
    if (knot.tube >= knot.minor || knot.minor >= knot.major) {
        throw Error("torus knot: tube must be less than minor, and minor less than major");
    }
}

}  // namespace

Mesh torus_knot(const TorusKnot& knot, int segments, int sides) {
    check_knot(knot);
    check_count("torus knot: segments", segments, 3, 65536);
    check_count("torus knot: sides", sides, 3, max_steps);
    Mesh mesh;
    append_grid(mesh, {.columns = segments, .rows = sides}, [&](double column, double row) {
        const Frame frame = frame_at(knot, static_cast<int>(column), segments);
        const glm::dvec2 round = turn(row, sides);
        // A tube's normal points from its centre line, however the frame twists.
        const glm::dvec3 normal = round.x * frame.normal - round.y * frame.binormal;
        return SurfacePoint{.position = frame.centre + static_cast<double>(knot.tube) * normal,
                            .normal = normal,
                            .uv = {column / segments, row / sides}};
    });
    return mesh;
}

}  // namespace glint
