#include "framework/app/probe.hpp"

#include "framework/app/picture.hpp"
#include "framework/raster/renderer.hpp"
#include "tests/unit/app/small_lesson.hpp"

#include <doctest/doctest.h>

#include <array>
#include <cmath>
#include <optional>
#include <sstream>

namespace glint {
namespace {

// The numbers of the line that begins with name: float, double and their difference.
std::optional<std::array<double, 3>> line_of(const std::string& text, const std::string& name) {
    std::istringstream lines(text);
    for (std::string line; std::getline(lines, line);) {
        if (line.starts_with(name)) {
            std::istringstream numbers(line.substr(name.size()));
            std::array<double, 3> values{};
            if (numbers >> values[0] >> values[1] >> values[2]) {
                return values;
            }
        }
    }
    return std::nullopt;
}

std::array<double, 3> numbers_of(const std::string& text, const std::string& name) {
    CAPTURE(text);
    CAPTURE(name);
    const auto values = line_of(text, name);
    REQUIRE(values);
    return *values;
}

struct Pictures {
    LinearImage linear;
    Image<float> depth;
    Image<std::int32_t> triangle;
};

Pictures pictures(const Lesson& lesson, const Options& o, const Scene& scene) {
    Pictures p;
    Renderer renderer(o.settings);
    const ShaderSet set = lesson.shaders(scene, o.parameters);
    renderer.render(scene.mesh, view_of(scene, o.width, o.height), set.shaders,
                    {.linear = &p.linear,
                     .depth = &p.depth,
                     .triangle = &p.triangle,
                     .background = scene.background});
    return p;
}

void check_pixel(const Lesson& lesson, Options o, const Scene& scene, const Pictures& expected,
                 int x, int y) {
    CAPTURE(x);
    CAPTURE(y);
    o.probe = {x, y};
    const std::string text = "\n" + explain_pixel(lesson, o, scene);
    const std::int32_t triangle = expected.triangle(x, y);
    if (triangle == no_triangle) {
        CHECK(text.find("nothing is drawn here") != std::string::npos);
        return;
    }
    CHECK(text.find("\ntriangle " + std::to_string(triangle) + "\n") != std::string::npos);
    const auto number = static_cast<std::size_t>(triangle);
    const std::string& material = scene.materials[scene.mesh.materials[number]].name;
    CHECK(text.find("\nmaterial " + material + "\n") != std::string::npos);

    // The same radiance as in the picture, in float and nearly so in double.
    for (int c = 0; c < 3; ++c) {
        const auto radiance = numbers_of(text, std::string("radiance.") + "rgb"[c]);
        CHECK(std::abs(radiance[0] - double{expected.linear(x, y)[c]}) <= 1e-5);
        CHECK(std::abs(radiance[1] - radiance[0]) <= 1e-4);
        CHECK(radiance[2] == doctest::Approx(radiance[0] - radiance[1]).epsilon(1e-3));
    }
    // Nine digits give a float back exactly.
    CHECK(static_cast<float>(numbers_of(text, "depth")[0]) == expected.depth(x, y));
    for (const std::string kind : {"barycentric ", "screen barycentric "}) {
        double sum[2] = {0, 0};
        for (const char* i : {"0", "1", "2"}) {
            const auto b = numbers_of(text, kind + i);
            CHECK(b[0] >= -1e-6);
            sum[0] += b[0];
            sum[1] += b[1];
        }
        CHECK(sum[0] == doctest::Approx(1).epsilon(1e-6));
        CHECK(sum[1] == doctest::Approx(1).epsilon(1e-6));
    }
    numbers_of(text, "N.L");  // a term that the shader names
}

TEST_CASE("the probe says what the picture shows") {
    const Lesson lesson = small_lesson();
    const Scene scene = ball_before_wall();
    for (const Rasterizer rasterizer : {Rasterizer::tiles, Rasterizer::scanline}) {
        Options o = small_options();
        o.settings.rasterizer = rasterizer;
        const Pictures expected = pictures(lesson, o, scene);
        for (int y = 3; y < o.height; y += 16) {
            for (int x = 2; x < o.width; x += 14) {
                check_pixel(lesson, o, scene, expected, x, y);
            }
        }
        check_pixel(lesson, o, scene, expected, 0, 0);
        check_pixel(lesson, o, scene, expected, o.width - 1, o.height - 1);
    }
}

TEST_CASE("the probe looks through faces that are culled") {
    const Lesson lesson = small_lesson();
    const Scene outside = ball_before_wall();
    Scene scene = outside;
    scene.camera.eye = {0, 0, 0.1F};  // inside the ball
    scene.camera.target = {0, 0, -1};
    scene.camera.near = 0.01F;
    Options o = small_options();
    o.probe = {45, 35};
    CHECK(explain_pixel(lesson, o, scene).find("material ball") != std::string::npos);
    o.settings.cull = Cull::back;
    CHECK(explain_pixel(lesson, o, scene).find("material wall") != std::string::npos);
}

TEST_CASE("a clipped triangle says so") {
    const Lesson lesson = small_lesson();
    Scene scene = ball_before_wall();
    scene.mesh = plane(40, 40, 1, 1);
    scene.camera.eye = {0, 1, 4};
    Options o = small_options();
    o.probe = {45, 60};
    CHECK(explain_pixel(lesson, o, scene).find("clipped") != std::string::npos);
}

}  // namespace
}  // namespace glint
