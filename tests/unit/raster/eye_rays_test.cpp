#include "framework/raster/eye_rays.hpp"

#include "framework/scene/camera.hpp"
#include "framework/raster/plug.hpp"
#include "tests/unit/raster/drawing.hpp"
#include "tests/worst.hpp"

#include <doctest/doctest.h>

#include <cmath>

namespace glint {
namespace {

// Where a world point appears, in pixels; of doubles, to see the rays' error and no other.
glm::dvec2 window(const View& view, const glm::dvec3& point) {
    const glm::dvec4 clip = glm::dmat4(view.clip_from_world) * glm::dvec4(point, 1);
    return {(1 + clip.x / clip.w) * view.width / 2, (1 - clip.y / clip.w) * view.height / 2};
}

TEST_CASE("from what a pixel shows the ray leads to the eye") {
    const Camera cameras[] = {
        {},
        {.eye = {3, -2, 5}, .target = {1, 1, 1}, .up = {0.2F, 1, 0}, .fov_degrees = 90},
        {.eye = {0, 12, 60}, .target = {0, -2, 0}, .fov_degrees = 8.8F, .near = 30, .far = 1e5F},
        {.eye = {0, 0, 1}, .fov_degrees = 160, .near = 1e-4F},
    };
    for (const Camera& camera : cameras) {
        for (const auto& [width, height] : {std::pair{640, 480}, {1, 1}, {16384, 9}}) {
            const float aspect = static_cast<float>(width) / static_cast<float>(height);
            const View view{clip_from_world(camera, aspect), width, height};
            const EyeRays rays = eye_rays(view);
            const glm::dvec3 forward = normalize(glm::dvec3(camera.target - camera.eye));
            const glm::dvec3 middle = rays.at(0.5 * width, 0.5 * height);
            CHECK(length(middle) == doctest::Approx(1));
            CHECK(length(middle + forward) < 1e-5);
            double worst = 0;
            for (const glm::dvec3& aside :
                 {glm::dvec3(0), glm::dvec3(0.1, 0.2, -0.1), glm::dvec3(-0.3, 0.1, 0.2)}) {
                const glm::dvec3 point = glm::dvec3(camera.eye) + 4.0 * (forward + aside);
                const glm::dvec2 at = window(view, point);
                const glm::dvec3 ray = rays.at(at.x, at.y);
                const glm::dvec3 way = glm::dvec3(camera.eye) - point;
                worst = worse(worst, length(normalize(ray) - normalize(way)));
            }
            CHECK(worst < 1e-5);  // the matrix holds floats
        }
    }
}

TEST_CASE("an eye infinitely far is in one direction, whence depth grows") {
    const EyeRays rays = eye_rays(window_view(100, 50));
    CHECK(rays.at(3, 4) == glm::dvec3(0, 0, 1));
    CHECK(rays.at(99, 1) == glm::dvec3(0, 0, 1));
}

// Shows the way to the eye, and beside it what is interpolated.
struct ShowWay {
    template <class T>
    struct Varyings {
        T third;
        Vec3<T> to_eye;
    };
    static Varyings<float> vertex(const Vertex& v) { return {v.position.z, glm::vec3(9)}; }
    template <Real T>
    Rgb<T> operator()(const Varyings<T>& in) const {
        return Rgb<T>(in.to_eye.x, in.to_eye.y, in.third);
    }
};

TEST_CASE("shaders are told it at every sample, by both rasterizers") {
    const Mesh mesh{.positions = {{-4, -3, -1}, {5, -3, -1}, {0, 4, -3}, {0, 0, -2}, {3, 1, -0.5F}},
                    .normals = {},
                    .uvs = {},
                    .triangles = {{0, 1, 2}, {3, 1, 4}},
                    .materials = {}};
    const Camera camera{.eye = {0.5F, 0.2F, 2}};
    const View view{clip_from_world(camera, 2), 150, 75};
    const EyeRays rays = eye_rays(view);
    const ShowWay shader;
    const Shader plugged = plug(shader);
    CHECK(plugged.varyings == 1);
    CHECK(plugged.to_eye);
    for (const Settings& settings : both_rasterizers({.threads = 2})) {
        CAPTURE(words(settings));
        const Drawn d = draw(mesh, view, plugged, settings);
        double worst = 0;
        int covered = 0;
        for (int y = 0; y < view.height; ++y) {
            for (int x = 0; x < view.width; ++x) {
                if (d.triangle(x, y) == no_triangle) {
                    continue;
                }
                ++covered;
                const glm::dvec3 way = rays.at(x + 0.5, y + 0.5);
                const Rgb<float>& shown = d.linear(x, y);
                worst = worse(worst, std::hypot(shown.r - way.x, shown.g - way.y));
                CHECK(shown.b <= -0.5F);
                CHECK(shown.b >= -3.0F);
            }
        }
        CHECK(covered > 3000);
        CHECK(worst < 2e-7);
    }
    // By sample it is the mean of the samples' ways, which is that of the pixel's middle.
    for (const Settings& settings :
         both_rasterizers({.threads = 1, .samples = 4, .sample_shading = true})) {
        CAPTURE(words(settings));
        const Drawn d = draw(mesh, view, plugged, settings);
        const glm::dvec3 way = rays.at(70.5, 40.5);
        REQUIRE(d.triangle(70, 40) == 0);
        CHECK(std::hypot(d.linear(70, 40).r - way.x, d.linear(70, 40).g - way.y) < 2e-7);
    }
}

}  // namespace
}  // namespace glint
