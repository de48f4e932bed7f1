#include "lessons/02_radiometry/radiometry.hpp"
#include "framework/app/lesson.hpp"
#include "framework/scene/false_colour.hpp"
#include "framework/geometry/shapes.hpp"
#include "framework/math/pow.hpp"

#include <glm/gtc/matrix_transform.hpp>

namespace {

using namespace glint;

constexpr float half_room = 2.3F;
constexpr float room_height = 5.0F;
constexpr float lamp_radius = 1.0F;

// A floor and three walls about the y axis, and the edge of the lamp.
Scene room(const Parameters& p) {
    const glm::mat4 stay(1.0F);
    const float quarter_turn = glm::half_pi<float>();
    const glm::mat4 back = glm::rotate(glm::translate(stay, {0, room_height / 2, -half_room}),
                                       quarter_turn, glm::vec3(1, 0, 0));
    const Mesh wall = transform(plane(2 * half_room, room_height, 1, 1), back);
    Scene s;
    s.materials = {{.name = "wall"}, {.name = "lamp"}};
    append(s.mesh, plane(2 * half_room, 2 * half_room, 1, 1), 0);
    for (const float turns : {-1.0F, 0.0F, 1.0F}) {
        append(s.mesh, transform(wall, glm::rotate(stay, turns * quarter_turn, glm::vec3(0, 1, 0))),
               0);
    }
    append(s.mesh,
           transform(torus(lamp_radius, 0.03F, 96, 12), glm::translate(stay, {0, p["height"], 0})),
           1);
    s.camera = {
        .eye = {0, 7.0F, 9.5F}, .target = {0, 1.95F, 0}, .fov_degrees = 47.0F, .near = 1.0F};
    s.background = Rgb<float>(0.010F, 0.012F, 0.016F);
    return s;
}

// Irradiance over pi L, in the colours of false_colour() by its logarithm: eight halvings.
struct Irradiance {
    float height;  // of the lamp
    bool is_lamp;

    template <class T>
    struct Varyings {
        Vec3<T> position, normal;
    };
    static Varyings<float> vertex(const Vertex& v) { return {v.position, v.normal}; }

    template <Real T, class Noting = Silent>
    Rgb<T> operator()(const Varyings<T>& in, const Noting& note = {}) const {
        if (is_lamp) {
            return Rgb<T>(T(1.0F));
        }
        const Vec3<T> N = normalize_or(in.normal, Vec3<T>(T(0.0F)));
        const Vec3<T> way = glm::vec3(0, height, 0) - in.position;  // to the middle of the lamp
        const T aside = sqrt(way.x * way.x + way.z * way.z);
        const Vec2<T> e = irradiance_of_disk(T(lamp_radius), way.y, aside);
        const T inwards = (N.x * way.x + N.z * way.z) / max(aside, T(1e-6F));
        const T disk = e.x * inwards + e.y * N.y;
        const T square = dot(way, way);
        const T point = lamp_radius * lamp_radius * way.y * dot(N, way) / (square * square);
        note("E by the disk, / pi L", disk);
        note("E by inverse squares", point);
        const T E = select(in.position.x < T(0.0F), disk, point);
        return false_colour(T(1.0F) + log2(max(E, T(0.0F))) * T(0.125F));
    }
};

}  // namespace

int main(int argc, char** argv) {
    return run_lesson(
        argc, argv,
        {.name = "02_radiometry",
         .title = "Lesson 2: irradiance under a disk lamp, and by inverse squares",
         .parameters = {{"height", 1.5F, 0.1F, 5, "of the lamp above the floor; its radius is 1"}},
         .panels = {{{"height", 0.5F}}, {{"height", 1.5F}}, {{"height", 4}}},
         .stage = room,
         .shaders = shade_each_material([](const Scene&, const Material& m, const Parameters& p) {
             return Irradiance{p["height"], m.name == "lamp"};
         })});
}
