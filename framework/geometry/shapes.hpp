// Meshes of shapes that have a formula: their normals are exact, not averaged from triangles.
//
// All are centred on the origin, y up, counter-clockwise seen from outside. u runs to the right
// and v up for who looks from outside, both 0..1 unless said; vertices are doubled where u or v
// jumps, at exactly equal positions. Lengths are 1e-6 to 1e6, steps in one direction at most 4096.
// A parameter out of its range is an Error that names it.
#pragma once

#include "framework/geometry/mesh.hpp"

#include <span>

namespace glint {

// Longitudes and latitudes: 2 segments (rings - 1) triangles, fans at the poles. segments 3.. go
// round the y axis, u = 0 is at -z; rings 2.. go from the lower pole, v = 0, to the upper.
Mesh sphere(float radius, int segments, int rings);

// 20 * 4^subdivisions nearly equal triangles; subdivisions 0..8. u and v as on the sphere, but u
// runs on beyond 1 in the triangles that cross the seam: the texture has to repeat.
Mesh icosphere(float radius, int subdivisions);

// A ring round the y axis: 2 segments sides triangles. major is the radius of the centre line,
// minor < major that of the tube; segments 3.. go round the axis, sides 3.. round the tube.
Mesh torus(float major, float minor, int segments, int sides);

// A tube of radius tube along a curve that winds p times round the y axis and q times round the
// centre line of a torus; p and q 1..64 without common divisor. tube < minor < major. A tube
// thicker than half the gap between its windings passes through itself.
struct TorusKnot {
    int p = 2;
    int q = 3;
    float major = 1.0F;
    float minor = 0.4F;
    float tube = 0.15F;
};
Mesh torus_knot(const TorusKnot& knot, int segments, int sides);  // segments 3.. along the curve

// A rectangle in the xz plane that faces +y; u runs along x, v along -z. columns, rows 1.. .
Mesh plane(float width, float depth, int columns, int rows);

// Six faces with normals of their own; u and v 0..1 on each.
Mesh box(const glm::vec3& size);

// A box whose edges and corners are parts of cylinders and spheres of the given radius, less than
// half the smallest side; 2 steps strips round an edge, steps 1..1024. u and v 0..1 on each face.
Mesh rounded_box(const glm::vec3& size, float radius, int steps);

// A profile turned round the y axis. Points are (distance from the axis >= 0, height); outside is
// to the right of who walks along the profile, so a solid's profile goes upwards. segments 3.. .
//
// A polyline of two points or more: each stretch is a piece of a cone with sharp edges between.
Mesh surface_of_revolution(std::span<const glm::vec2> points, int segments);
//
// Cubic Bezier curves end to end: 3 k + 1 control points for k curves, each cut in steps 2.. .
// A curve that stops on the way (zero derivative) has no normal there and is an Error.
Mesh surface_of_revolution_bezier(std::span<const glm::vec2> control, int steps, int segments);

// Newell's teapot (1975) with the bottom that Crow gave it (1987): 32 Bezier patches, each cut
// in steps x steps cells, 2..256; 64 steps^2 - 8 steps triangles. It stands on y = 0, is 3.15
// high and points its spout along +x. As in the original the spout, the handle and the gap under
// the lid are open, and spout and handle run on into the body.
Mesh teapot(int steps);

}  // namespace glint
