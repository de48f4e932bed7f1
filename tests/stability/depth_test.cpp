// What is in front: the near plane, the resolution of depth, faces in one plane.
#include "framework/scene/camera.hpp"
#include "framework/raster/plug.hpp"
#include "framework/raster/transform.hpp"
#include "framework/geometry/shapes.hpp"
#include "tests/stability/row.hpp"
#include "tests/unit/raster/drawing.hpp"
#include "tests/unit/raster/rays.hpp"

#include <algorithm>
#include <array>

namespace glint::stability {
namespace {

constexpr int side = 64;

View view_of(const Camera& camera) {
    return {clip_from_world(camera, 1), side, side};
}

template <class Wrong>
double count(Wrong wrong) {
    double pixels = 0;
    for (int y = 0; y < side; ++y) {
        for (int x = 0; x < side; ++x) {
            pixels += wrong(x, y) ? 1 : 0;
        }
    }
    return pixels;
}

Rgb<float> grey_if(bool covered) {
    return covered ? Rgb<float>(0.4F) : Rgb<float>(0.02F);
}

// Inside a triangle of window positions, whichever way it winds.
template <Real T>
bool inside(const std::array<Vec2<double>, 3>& v, double x, double y) {
    bool left = false;
    bool right = false;
    for (std::size_t i = 0; i < 3; ++i) {
        const auto p = v[i];
        const auto q = v[(i + 1) % 3];
        const double e = (q.x - p.x) * (y - p.y) - (q.y - p.y) * (x - p.x);
        left = left || !(e >= 0);
        right = right || !(e <= 0);
    }
    return !(left && right);
}

TEST_CASE("no near plane: w = 0 and below") {
    const Camera camera{.eye = {0, 1, 0}, .target = {0.1F, 0.9F, -1}, .near = 0.01F, .far = 1e4F};
    Mesh floor;  // a corner behind the eye and one in its plane
    floor.positions = {{-900, 0, -900}, {900, 0, -900}, {50, 0, 800}, {-900, 0, 0}};
    floor.triangles = {{0, 2, 1}, {0, 3, 2}};
    const View view = view_of(camera);
    const Rays rays(camera, side, side);
    const auto floor_at = [&](int x, int y) {  // of what is seen, z from -900 to 0
        const glm::dvec3 d = rays.direction(x + 0.5, y + 0.5);
        const double z = d.y < 0 ? d.z / -d.y : 1;
        return d.y < 0 && z > -900;
    };
    const auto naive = [&]<Real T>(int x, int y) {
        for (const glm::uvec3& t : floor.triangles) {
            std::array<Vec2<double>, 3> v;
            for (int i = 0; i < 3; ++i) {
                const glm::vec3 p = floor.positions[t[i]];
                const auto at = window_position(
                    clip_position(view.clip_from_world, T(p.x), T(p.y), T(p.z)), view);
                v[static_cast<std::size_t>(i)] = {value(at.x), value(at.y)};
            }
            if (inside<T>(v, x + 0.5, y + 0.5)) {
                return true;
            }
        }
        return false;
    };
    const auto shown = draw(floor, view, plug(show_uv), {}).triangle;
    picture(
        "no_near_plane", side, side, 3,
        [&](int x, int y) { return grey_if(naive.operator()<float>(x, y)); },
        [&](int x, int y) { return grey_if(shown(x, y) != no_triangle); });
    row(in_all_numbers([&]<Real T>() {
            const auto drawn = draw(floor, view, plug(show_uv), settings_of<T>()).triangle;
            return Errors{
                count([&](int x, int y) { return naive.operator()<T>(x, y) != floor_at(x, y); }),
                count(
                    [&](int x, int y) { return (drawn(x, y) != no_triangle) != floor_at(x, y); })};
        }),
        1000, 0);
}

// Depth that rises with the distance d, as OpenGL and Direct3D had it: 0 at near, 1 at far.
template <Real T>
double rising_depth(const Camera& camera, double d) {
    const T n(camera.near);
    const T f(camera.far);
    return value(f / (f - n) - f * n / (f - n) / T(d));
}
template <Real T>
double reversed_depth(const Camera& camera, double d) {
    const glm::mat4 m = clip_from_world(camera, 1);
    const auto clip = clip_position(m, T(0.0F), T(0.0F), T(-d));
    return value(window_position(clip, View{m, side, side}).z);
}

TEST_CASE("depth that rises to 1: far/near = 1e6") {
    const Camera camera{.eye = {0, 0, 0}, .target = {0, 0, -1}, .near = 0.1F, .far = 1e5F};
    // The widest gap, as a share of the distance, across which two walls have one depth.
    const auto widest = [](const auto& depth) {
        double gap = 0;
        for (double d = 0.2; d < 4e4; d *= 1.37) {
            for (double g = 0.5; g > 1e-9; g /= 2) {
                if (depth(d * (1 + g)) == depth(d)) {
                    gap = std::max(gap, g);
                }
            }
        }
        return gap;
    };
    const Rays rays(camera, side, side);
    const auto shade = [&](const auto& hidden) {  // two walls, the farther one dark
        return [&](int x, int y) {
            const double d = 3e3 * std::exp(0.6 * rays.direction(x, y).x + 0.1 * y / side);
            return hidden(d) ? Rgb<float>(0.6F, 0.3F, 0.1F) : Rgb<float>(0.02F, 0.05F, 0.2F);
        };
    };
    picture("rising_depth", side, side, 3, shade([&](double d) {
                return rising_depth<float>(camera, d) < rising_depth<float>(camera, 1.001 * d);
            }),
            shade([&](double d) {
                return reversed_depth<float>(camera, d) > reversed_depth<float>(camera, 1.001 * d);
            }));
    row(in_all_numbers([&]<Real T>() {
            return Errors{widest([&](double d) { return rising_depth<T>(camera, d); }),
                          widest([&](double d) { return reversed_depth<T>(camera, d); })};
        }),
        0.01, 1e-6);
}

// Two triangles of the floor y = 0.
void add_floor(Mesh& mesh, float left, float right, float front, float back) {
    const auto i = static_cast<std::uint32_t>(mesh.positions.size());
    mesh.positions.insert(mesh.positions.end(),
                          {{left, 0, front}, {right, 0, front}, {right, 0, back}, {left, 0, back}});
    mesh.triangles.emplace_back(i, i + 1, i + 2);
    mesh.triangles.emplace_back(i, i + 2, i + 3);
}

TEST_CASE("faces in one plane: a mark on the floor, with corners of its own or the floor's") {
    const Camera camera{
        .eye = {0.3F, 1, 3}, .target = {0, 0, 0}, .up = {0.2F, 1, 0}, .near = 0.1F, .far = 100};
    Mesh own;
    add_floor(own, -1.31F, 1.17F, 1.73F, -1.91F);
    Mesh same = own;
    add_floor(own, -9, 9, 2, -9);
    same.triangles.push_back(same.triangles[0]);  // a copy, to be hidden by what came first
    same.triangles.push_back(same.triangles[1]);
    const auto beaten = [&](const Mesh& mesh, const Settings& settings) {
        const auto winner = draw(mesh, view_of(camera), plug(show_uv), settings).triangle;
        const auto alone =
            draw({mesh.positions, {}, {}, {mesh.triangles[0], mesh.triangles[1]}, {}},
                 view_of(camera), plug(show_uv), settings)
                .triangle;
        return count([&](int x, int y) { return alone(x, y) != no_triangle && winner(x, y) > 1; }) /
               count([&](int x, int y) { return alone(x, y) != no_triangle; });
    };
    const auto shown = draw(own, view_of(camera), plug(show_uv), {}).triangle;
    const auto cured = draw(same, view_of(camera), plug(show_uv), {}).triangle;
    const auto shade = [](const Image<std::int32_t>& winner) {
        return [&](int x, int y) {
            return winner(x, y) == no_triangle ? Rgb<float>(0)
                   : winner(x, y) > 1          ? Rgb<float>(0.02F, 0.05F, 0.2F)
                                               : Rgb<float>(0.6F, 0.3F, 0.1F);
        };
    };
    picture("one_plane", side, side, 3, shade(shown), shade(cured));
    row(in_all_numbers([&]<Real T>() {
            return Errors{beaten(own, settings_of<T>()), beaten(same, settings_of<T>())};
        }),
        0.1, 0);
}

}  // namespace
}  // namespace glint::stability
