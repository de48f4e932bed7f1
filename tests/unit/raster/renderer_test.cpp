#include "framework/raster/renderer.hpp"

#include "framework/raster/plug.hpp"
#include "framework/geometry/shapes.hpp"
#include "tests/unit/raster/drawing.hpp"
#include "tests/unit/refusal.hpp"

#include <doctest/doctest.h>

#include <string>

namespace glint {
namespace {

TEST_CASE("settings out of their range are refused by name") {
    const struct {
        Settings settings;
        const char* name;
    } cases[] = {{{.lanes = 0}, "lanes"},       {{.lanes = 2}, "lanes"},
                 {{.lanes = 32}, "lanes"},      {{.lanes = -4}, "lanes"},
                 {{.threads = 0}, "threads"},   {{.threads = -1}, "threads"},
                 {{.threads = 257}, "threads"}, {{.samples = 0}, "samples"},
                 {{.samples = 3}, "samples"},   {{.samples = 32}, "samples"}};
    for (const auto& [settings, name] : cases) {
        for (const Rasterizer rasterizer : {Rasterizer::tiles, Rasterizer::scanline}) {
            Settings s = settings;
            s.rasterizer = rasterizer;
            CAPTURE(words(s));
            CHECK(refusal([&] { const Renderer renderer(s); }).starts_with(name));
        }
    }
}

// 1 in double, 0 in float: a millionth of a float's last place is lost beside 1.
struct NeedsDouble {
    template <class T>
    struct Varyings {
        T one;
    };
    static Varyings<float> vertex(const Vertex&) { return {1.0F}; }
    template <Real T>
    Rgb<T> operator()(const Varyings<T>& in) const {
        const T tiny(1e-12F);
        return Rgb<T>(((in.one + tiny) - in.one) / tiny);
    }
};

TEST_CASE("the reference is scanline in double") {
    Mesh mesh;
    mesh.positions = {{0, 0, 0.5F}, {16, 0, 0.5F}, {0, 16, 0.5F}};
    mesh.triangles = {{0, 1, 2}};
    const NeedsDouble shader;
    const Drawn f =
        draw(mesh, window_view(8, 8), plug(shader), {.rasterizer = Rasterizer::scanline});
    const Drawn d =
        draw(mesh, window_view(8, 8), plug(shader), {.rasterizer = Rasterizer::reference});
    REQUIRE(d.triangle(4, 4) != no_triangle);
    CHECK(f.linear(4, 4).r == 0.0F);
    CHECK(d.linear(4, 4).r == doctest::Approx(1).epsilon(1e-3));
    CHECK(d.triangle == f.triangle);
    CHECK(d.depth == f.depth);
}

TEST_CASE("a view out of its range and missing shaders are refused, and nothing is drawn") {
    const Mesh mesh = plane(1, 1, 1, 1);
    const OneColour shader;
    const Shader one = plug(shader);
    for (const Settings& settings : both_rasterizers()) {
        CAPTURE(words(settings));
        Renderer renderer(settings);
        SrgbImage picture(3, 2, {1, 2, 3, 4});
        const SrgbImage before = picture;
        const auto render = [&](const Mesh& m, int width, int height, std::size_t shaders) {
            return refusal([&] {
                View view = window_view(8, 8);
                view.width = width;
                view.height = height;
                renderer.render(m, view, std::span(&one, shaders), {.srgb = &picture});
            });
        };
        CHECK(render(mesh, 0, 1, 1).starts_with("picture size"));
        CHECK(render(mesh, 1, 0, 1).starts_with("picture size"));
        CHECK(render(mesh, -5, 1, 1).starts_with("picture size"));
        CHECK(render(mesh, 16385, 1, 1).starts_with("picture size"));
        CHECK(render(mesh, 1, 16385, 1).starts_with("picture size"));
        CHECK(render(mesh, 4, 4, 0).starts_with("shaders"));
        Mesh two = mesh;
        two.materials = {0, 1};
        CHECK(render(two, 4, 4, 1).starts_with("shaders"));
        CHECK(picture == before);
        CHECK(render(mesh, 16384, 1, 1).empty());
        CHECK(picture.width() == 16384);
        CHECK(render(mesh, 1, 16384, 1).empty());
        CHECK(picture.height() == 16384);
    }
}

TEST_CASE("a mesh whose arrays do not fit together is refused") {
    const auto refused = [](auto change) {
        Mesh mesh;
        mesh.positions = {{-1, -1, 0.5F}, {1, -1, 0.5F}, {0, 1, 0.5F}};
        mesh.normals.assign(3, {0, 0, 1});
        mesh.uvs.assign(3, {0, 0});
        mesh.triangles = {{0, 1, 2}};
        mesh.materials = {0};
        change(mesh);
        const Shader shader = plug(show_position);
        SrgbImage picture;
        try {
            Renderer(Settings{})
                .render(mesh, {glm::mat4(1.0F), 4, 4}, {&shader, 1}, {.srgb = &picture});
            return false;
        } catch (const Error&) {
            return picture.empty();
        }
    };
    CHECK(!refused([](Mesh&) {}));
    CHECK(!refused([](Mesh& m) { m.normals.clear(); }));
    CHECK(refused([](Mesh& m) { m.normals.pop_back(); }));
    CHECK(refused([](Mesh& m) { m.uvs.pop_back(); }));
    CHECK(refused([](Mesh& m) { m.materials.push_back(0); }));
    CHECK(refused([](Mesh& m) { m.triangles.push_back({0, 1, 2}); }));
}

TEST_CASE("nothing to draw leaves the background") {
    const OneColour shader;
    for (const int samples : {1, 4}) {
        for (const Settings& settings : both_rasterizers({.threads = 2, .samples = samples})) {
            CAPTURE(words(settings));
            const Drawn d = draw(Mesh{}, window_view(70, 5), plug(shader), settings, {0, 1, 0.5F});
            CHECK(d.linear == LinearImage(70, 5, {0, 1, 0.5F}));
            CHECK(d.srgb == SrgbImage(70, 5, {0, 255, 188, 255}));
            CHECK(d.depth == Image<float>(70, 5, 0.0F));
            CHECK(d.triangle == Image<std::int32_t>(70, 5, no_triangle));
            CHECK(d.statistics.fragments_shaded == 0);
            CHECK(d.statistics.triangles_in == 0);
        }
    }
}

TEST_CASE("one renderer draws frames of any size, one after the other, as new ones would") {
    const Mesh mesh{.positions = {{-3, -2, 0.5F}, {300, 10, 0.25F}, {20, 200, 0.75F}},
                    .normals = {},
                    .uvs = {},
                    .triangles = {{0, 1, 2}},
                    .materials = {}};
    for (const int samples : {1, 4}) {
        for (const Settings& settings : both_rasterizers({.threads = 2, .samples = samples})) {
            CAPTURE(words(settings));
            Renderer renderer(settings);
            LinearImage picture;
            for (const auto& [width, height] :
                 {std::pair(5, 3), {200, 130}, {64, 64}, {1, 1}, {65, 200}, {200, 130}}) {
                const View view = window_view(width, height);
                const Shader shader = plug(show_position);
                const Statistics s =
                    renderer.render(mesh, view, std::span(&shader, 1), {.linear = &picture});
                const Drawn fresh = draw(mesh, view, shader, settings);
                CHECK(picture == fresh.linear);
                CHECK(s.fragments_shaded == fresh.statistics.fragments_shaded);
                CHECK(s.triangles_visible == fresh.statistics.triangles_visible);
            }
        }
    }
}

// Some pixels of most tiles, all of some, none of others; of one material or of two.
Mesh scattered(int materials) {
    Mesh mesh;
    const auto add = [&](float left, float top, float size) {
        const auto n = static_cast<std::uint32_t>(mesh.positions.size());
        mesh.positions.insert(
            mesh.positions.end(),
            {{left, top, 0.5F}, {left + size, top, 0.5F}, {left, top + size, 0.5F}});
        mesh.triangles.push_back({n, n + 1, n + 2});
        mesh.materials.push_back(
            static_cast<std::uint16_t>(n / 3 % static_cast<unsigned>(materials)));
    };
    add(130, 60, 300);
    add(66, 70, 10);
    add(3, 200, 4);
    add(400, 20, 1.5F);
    return mesh;
}

TEST_CASE("a picture that was in use is drawn over everywhere") {
    const OneColour light{{0.5F, 0.25F, 1}};
    const OneColour dark{{0.1F, 0, 0.2F}};
    const Shader shaders[] = {plug(light), plug(dark)};
    for (const int materials : {1, 2}) {
        const Mesh mesh = scattered(materials);
        for (const auto& [width, height] :
             {std::pair(448, 256), {448, 270}, {450, 270}, {40, 300}}) {
            const View view = window_view(width, height);
            const std::span used(shaders, static_cast<std::size_t>(materials));
            const Rgb<float> background(0.2F, 0.3F, 0.4F);
            const Drawn expected =
                draw(mesh, view, used, {.rasterizer = Rasterizer::scanline}, background);
            for (const int threads : {1, 2, 3}) {
                for (const Settings& settings : both_rasterizers({.threads = threads})) {
                    CAPTURE(words(settings));
                    Renderer renderer(settings);
                    SrgbImage picture(width, height, {7, 8, 9, 10});
                    renderer.render(mesh, view, used, {.srgb = &picture, .background = background});
                    CHECK(picture == expected.srgb);
                    renderer.render(mesh, view, used, {.srgb = &picture});
                    renderer.render(mesh, view, used, {.srgb = &picture, .background = background});
                    CHECK(picture == expected.srgb);
                }
            }
        }
    }
}

TEST_CASE("the statistics count what was asked for") {
    // Two squares one behind the other, the far one hidden, and a triangle beside the window.
    Mesh mesh{.positions = {{2, 2, 0.75F},
                            {10, 2, 0.75F},
                            {10, 10, 0.75F},
                            {2, 10, 0.75F},
                            {2, 2, 0.5F},
                            {10, 2, 0.5F},
                            {10, 10, 0.5F},
                            {2, 10, 0.5F},
                            {-9, 0, 0.5F},
                            {-5, 0, 0.5F},
                            {-5, 5, 0.5F}},
              .normals = {},
              .uvs = {},
              .triangles = {{4, 5, 6}, {4, 6, 7}, {0, 1, 2}, {0, 2, 3}, {8, 9, 10}},
              .materials = {}};
    for (const Settings& settings : both_rasterizers()) {
        CAPTURE(words(settings));
        const Statistics s =
            draw(mesh, window_view(16, 16), plug(show_position), settings).statistics;
        CHECK(s.triangles_in == 5);
        CHECK(s.triangles_not_finite == 0);
        CHECK(s.triangles_visible == 2);
        CHECK(s.fragments_shaded == 64);
        CHECK(s.geometry_ms + s.visibility_ms + s.shading_ms + s.output_ms <= s.frame_ms * 1.001);
        CHECK(s.frame_ms > 0);
    }
}

TEST_CASE("back faces are left out where that is asked") {
    // Counter-clockwise for the viewer is a front face; y points down here.
    Mesh mesh{
        .positions = {{2, 2, 0.5F}, {2, 20, 0.5F}, {20, 2, 0.5F}, {90, 90, 0.5F}, {90, 9, 0.5F}},
        .normals = {},
        .uvs = {},
        .triangles = {{0, 1, 2}, {2, 3, 4}},
        .materials = {}};
    for (const Cull cull : {Cull::none, Cull::back}) {
        for (const Settings& settings : both_rasterizers({.cull = cull})) {
            CAPTURE(words(settings));
            const Drawn front = draw(mesh, window_view(100, 100), plug(show_position), settings);
            CHECK(front.statistics.triangles_visible == 2);
            Mesh turned = mesh;
            for (glm::uvec3& t : turned.triangles) {
                t = {t.x, t.z, t.y};
            }
            const Drawn back = draw(turned, window_view(100, 100), plug(show_position), settings);
            CHECK(back.statistics.triangles_visible == (cull == Cull::back ? 0 : 2));
            if (cull == Cull::none) {
                CHECK(back.triangle == front.triangle);
            }
        }
    }
}

}  // namespace
}  // namespace glint
