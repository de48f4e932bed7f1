#include "tests/bench/scenes.hpp"

#include "framework/geometry/obj.hpp"
#include "framework/geometry/shapes.hpp"
#include "framework/math/error.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <numbers>

namespace glint {
namespace {

const glm::vec3 near_eye{0, 0, 2.214F};

Material bench_material() {
    return {.name = "bench",
            .diffuse = Rgb<float>(0.5F, 0.3F, 0.2F),
            .specular = Rgb<float>(0.04F),
            .exponent = 50};
}

Scene lit_scene(Mesh mesh, const Camera& camera, int lights) {
    Scene s;
    s.camera = around(mesh, camera);
    s.mesh = std::move(mesh);
    s.materials = {bench_material()};
    s.lighting = bench_lights(lights);
    s.background = Rgb<float>(0.02F);
    return s;
}

// Sixteen shells, each nearer than all before: whatever is shaded as it comes is shaded in vain.
Mesh shells(int count) {
    Mesh all;
    for (int i = 0; i < count; ++i) {
        const float t = count == 1 ? 1.0F : static_cast<float>(i) / static_cast<float>(count - 1);
        append(all, sphere(0.5F + 0.5F * t, 46, 23));
    }
    return all;
}

// 69 k triangles with bumps that hide each other, over as many pixels as the scanned bunny.
Mesh bumpy_ball() {
    Mesh ball = sphere(1, 264, 132);
    for (glm::vec3& p : ball.positions) {
        const float bumps = std::sin(7 * p.x) * std::sin(8 * p.y) * std::sin(9 * p.z);
        p *= 0.0675F * (1 + 0.2F * bumps);
        p += glm::vec3(-0.017F, 0.11F, 0);
    }
    std::fill(ball.normals.begin(), ball.normals.end(), glm::vec3(0));
    for (const glm::uvec3& t : ball.triangles) {
        const glm::vec3 a = ball.positions[t.x];
        const glm::vec3 normal = cross(ball.positions[t.y] - a, ball.positions[t.z] - a);
        for (const unsigned corner : {t.x, t.y, t.z}) {
            ball.normals[corner] += normal;
        }
    }
    for (glm::vec3& n : ball.normals) {
        n = normalize_or(n, glm::vec3(0, 1, 0));
    }
    return ball;
}

Scene bunny(const std::string& file) {
    const glm::vec3 target(-0.017F, 0.11F, 0);
    return lit_scene(file.empty() ? bumpy_ball() : read_obj(file).mesh,
                     {.eye = {-0.017F, 0.11F, 0.24F}, .target = target}, 2);
}

using Maker = std::function<BenchScene(const std::string& bunny_file)>;

const std::vector<std::pair<std::string, Maker>>& makers() {
    static const std::vector<std::pair<std::string, Maker>> all{
        {"fill",
         [](const std::string&) {
             return BenchScene{"fill", "sphere of 2 k triangles, large",
                               bench_sphere(46, 23, near_eye, 2)};
         }},
        {"bunny",
         [](const std::string& file) {
             return BenchScene{"bunny", file.empty() ? "bumpy ball of 69 k triangles" : file,
                               bunny(file)};
         }},
        {"tiny",
         [](const std::string&) {
             return BenchScene{"tiny", "sphere of 1 M triangles, large",
                               bench_sphere(1024, 512, near_eye, 2)};
         }},
        {"far",
         [](const std::string&) {
             return BenchScene{"far", "sphere of 1 M triangles, far away",
                               bench_sphere(1024, 512, {0, 0, 8}, 2)};
         }},
        {"overdraw",
         [](const std::string&) {
             return BenchScene{"overdraw", "16 spheres, inner first",
                               lit_scene(shells(16), {.eye = near_eye}, 2)};
         }},
        {"lights",
         [](const std::string&) {
             return BenchScene{"lights", "fill with 16 lights", bench_sphere(46, 23, near_eye, 16)};
         }},
        {"small",
         [](const std::string&) {
             const Mesh pot = teapot(8);
             const Camera camera{.eye = {0, 4, 7}, .target = {0, 1.4F, 0}};
             return BenchScene{"small", "teapot, 320x240", lit_scene(pot, camera, 2), 320, 240};
         }},
        {"wide",
         [](const std::string&) {
             return BenchScene{"wide", "fill at 7680x4320", bench_sphere(46, 23, near_eye, 2), 7680,
                               4320};
         }},
    };
    return all;
}

}  // namespace

std::vector<std::string> bench_scene_names() {
    std::vector<std::string> names;
    for (const auto& [name, make] : makers()) {
        names.push_back(name);
    }
    return names;
}

BenchScene bench_scene(const std::string& name, const std::string& bunny_file) {
    for (const auto& [known, make] : makers()) {
        if (known == name) {
            return make(bunny_file);
        }
    }
    std::string known;
    for (const std::string& n : bench_scene_names()) {
        known += " " + n;
    }
    throw Error("scene " + name + " is not one of:" + known);
}

Scene bench_sphere(int segments, int rings, const glm::vec3& eye, int lights) {
    return lit_scene(sphere(1, segments, rings), {.eye = eye}, lights);
}

Lighting bench_lights(int count) {
    Lighting lighting;
    lighting.ambient = Rgb<float>(0.1F);
    for (int i = 0; i < count; ++i) {
        // A spiral by the golden angle: even for any count.
        const float z = (static_cast<float>(i) + 0.5F) / static_cast<float>(count);
        const float angle = static_cast<float>(i) * std::numbers::pi_v<float> * 0.763932F;
        const float side = std::sqrt(1 - z * z);
        lighting.directional.push_back(
            {glm::normalize(glm::vec3(side * std::cos(angle), side * std::sin(angle), z)),
             Rgb<float>(3.0F, 2.8F, 2.5F) / static_cast<float>(count)});
    }
    return lighting;
}

}  // namespace glint
