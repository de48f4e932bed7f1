// Of equal depths the triangle submitted first wins.
#include "framework/scene/camera.hpp"
#include "framework/raster/plug.hpp"
#include "tests/oracle/random.hpp"
#include "tests/unit/raster/drawing.hpp"

#include <doctest/doctest.h>

namespace glint {
namespace {

using oracle::Random;

Mesh many_triangles(std::uint64_t seed, int count) {
    Random random(seed);
    Mesh mesh;
    for (int i = 0; i < count; ++i) {
        const glm::vec3 place(random.real(-3, 3), random.real(-2, 2), random.real(-4, 3));
        for (int k = 0; k < 3; ++k) {
            mesh.positions.push_back(place + glm::vec3(random.real(-0.6, 0.6),
                                                       random.real(-0.6, 0.6),
                                                       random.real(-0.6, 0.6)));
        }
        const auto first = static_cast<std::uint32_t>(3 * i);
        mesh.triangles.push_back({first, first + 1, first + 2});
    }
    return mesh;
}

View view_among_triangles() {
    const Camera camera{.eye = {0, 0, 3}, .near = 0.5F, .far = 20};
    return {clip_from_world(camera, 1.5F), 150, 100};
}

TEST_CASE("copies of a triangle lose to the first of them, however many there are") {
    const View view = view_among_triangles();
    const Mesh once = many_triangles(3, 1900);
    Mesh thrice = once;  // long enough for several chunks of triangles
    for (int copy = 1; copy < 3; ++copy) {
        thrice.triangles.insert(thrice.triangles.end(), once.triangles.begin(),
                                once.triangles.end());
    }
    const OneColour black{Rgb<float>(0.0F)};
    const OneColour white{Rgb<float>(1.0F)};
    const std::vector<Shader> shaders{plug(black), plug(white)};
    thrice.materials.assign(thrice.triangles.size(), 1);
    std::fill_n(thrice.materials.begin(), once.triangles.size(), std::uint16_t{0});
    for (const int samples : {1, 4}) {
        for (const int threads : {1, 2, 7}) {
            for (Settings settings : both_rasterizers({.threads = threads, .samples = samples})) {
                CAPTURE(words(settings));
                const Drawn expected = draw(once, view, shaders, settings);
                const Drawn d = draw(thrice, view, shaders, settings);
                CHECK(expected.statistics.triangles_visible > 100);
                CHECK(d.statistics.triangles_visible == expected.statistics.triangles_visible);
                CHECK(d.triangle == expected.triangle);
                CHECK(d.depth == expected.depth);
                CHECK(std::ranges::all_of(d.linear.pixels(),
                                          [](const auto& c) { return c == Rgb<float>(0.0F); }));
            }
        }
    }
}

TEST_CASE("the order of submission decides nothing else") {
    const View view = view_among_triangles();
    const Mesh mesh = many_triangles(4, 800);
    Mesh backwards = mesh;
    std::reverse(backwards.triangles.begin(), backwards.triangles.end());
    const auto last = static_cast<std::int32_t>(mesh.triangles.size()) - 1;
    for (const Settings& settings : both_rasterizers()) {
        CAPTURE(words(settings));
        const Drawn d = draw(mesh, view, plug(show_position), settings);
        Drawn b = draw(backwards, view, plug(show_position), settings);
        for (std::int32_t& t : b.triangle.pixels()) {
            t = t == no_triangle ? t : last - t;
        }
        CHECK(b.depth == d.depth);
        CHECK(b.triangle == d.triangle);  // no two of these have a pixel's depth in common
    }
}

}  // namespace
}  // namespace glint
