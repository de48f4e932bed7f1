// The scanline rasterizer and the tiles draw the same picture: in any width of lanes, with any
// number of threads.
#include "framework/app/picture.hpp"
#include "framework/raster/assemble.hpp"
#include "framework/raster/plug.hpp"
#include "framework/raster/setup.hpp"
#include "tests/oracle/random.hpp"
#include "tests/pictures/lessons.hpp"
#include "tests/pictures/random_scene.hpp"
#include "tests/unit/raster/drawing.hpp"
#include "tests/worst.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <numeric>

namespace glint {
namespace {

using oracle::Random;

#ifdef EMULATOR
constexpr std::uint64_t scenes = 20;
constexpr int sample_counts[] = {1, 4};
#else
constexpr std::uint64_t scenes = 300;
constexpr int sample_counts[] = {1, 2, 4, 8, 16};
#endif

// The largest difference between components, relative where they are above 1.
double colour_difference(const LinearImage& a, const LinearImage& b) {
    double worst = 0;
    for (std::size_t i = 0; i < a.pixels().size(); ++i) {
        for (int c = 0; c < 3; ++c) {
            const double x = a.pixels()[i][c];
            const double y = b.pixels()[i][c];
            const double difference = std::abs(x - y) / std::max({1.0, std::abs(x), std::abs(y)});
            worst = worse(worst, difference);
        }
    }
    return worst;
}

int code_difference(const SrgbImage& a, const SrgbImage& b) {
    int worst = 0;
    for (std::size_t i = 0; i < a.pixels().size(); ++i) {
        const Rgba8 x = a.pixels()[i];
        const Rgba8 y = b.pixels()[i];
        worst = std::max({worst, std::abs(x.r - y.r), std::abs(x.g - y.g), std::abs(x.b - y.b),
                          std::abs(x.a - y.a)});
    }
    return worst;
}

template <class Pixel>
int differing(const Image<Pixel>& a, const Image<Pixel>& b) {
    const auto x = a.pixels();
    return static_cast<int>(x.size()) -
           static_cast<int>(std::inner_product(x.begin(), x.end(), b.pixels().begin(),
                                               std::size_t{}, std::plus<>(), std::equal_to<>()));
}

void check_same_bits(const Drawn& a, const Drawn& b) {
    CHECK(a.srgb == b.srgb);
    CHECK(a.linear == b.linear);
    CHECK(a.depth == b.depth);
    CHECK(a.triangle == b.triangle);
    CHECK(a.statistics.fragments_shaded == b.statistics.fragments_shaded);
    CHECK(a.statistics.triangles_visible == b.statistics.triangles_visible);
    CHECK(a.statistics.triangles_not_finite == b.statistics.triangles_not_finite);
}

void check_agreement(const Drawn& tiles, const Drawn& scanline, double tolerance) {
    CHECK(differing(tiles.triangle, scanline.triangle) == 0);
    CHECK(differing(tiles.depth, scanline.depth) == 0);
    CHECK(colour_difference(tiles.linear, scanline.linear) <= tolerance);
    CHECK(code_difference(tiles.srgb, scanline.srgb) <= 1);
    CHECK(tiles.statistics.fragments_shaded == scanline.statistics.fragments_shaded);
    CHECK(tiles.statistics.triangles_visible == scanline.statistics.triangles_visible);
    CHECK(tiles.statistics.triangles_not_finite == scanline.statistics.triangles_not_finite);
}

struct Task {
    const Mesh& mesh;
    View view;
    std::span<const Shader> shaders;
    Rgb<float> background;
    double tolerance;  // of colours
};

// Draws in every width of lanes, and in one of them with other numbers of threads.
void check_all_ways(const Task& task, Settings settings, int lanes_for_threads) {
    CAPTURE(task.view.width);
    CAPTURE(task.view.height);
    const auto drawn = [&] {
        return draw(task.mesh, task.view, task.shaders, settings, task.background);
    };
    settings.rasterizer = Rasterizer::scanline;
    const Drawn scanline = drawn();
    settings.rasterizer = Rasterizer::tiles;
    for (const int lanes : all_lanes()) {
        settings.lanes = lanes;
        settings.threads = 1;
        CAPTURE(words(settings));
        const Drawn tiles = drawn();
        check_agreement(tiles, scanline, task.tolerance);
        for (const int threads : {2, 7}) {
            if (lanes == lanes_for_threads) {
                settings.threads = threads;
                CAPTURE(threads);
                check_same_bits(drawn(), tiles);
            }
        }
    }
}

TEST_CASE("every lesson: scanline and tiles, all lanes, threads, samples and ways to draw") {
    const std::vector<int> lanes = all_lanes();
    std::size_t turn = 0;
    for (const LessonPicture& lesson : all_lessons()) {
        CAPTURE(lesson.name);
        const Scene scene = lesson.stage();
        const ShaderSet set = lesson.shaders(scene, lesson.parameters);
        const Task task{scene.mesh, view_of(scene, 130, 70), set.shaders, scene.background,
                        lesson.tolerance};
        for (const int samples : sample_counts) {
            for (const bool sample_shading : {false, true}) {
                for (const Cull cull : {Cull::none, Cull::back}) {
                    const Settings settings{
                        .samples = samples, .sample_shading = sample_shading, .cull = cull};
                    check_all_ways(task, settings, lanes[turn++ % lanes.size()]);
                }
            }
        }
    }
}

// Shows what was interpolated, in two ways that differ in the number of varyings.
struct ShowSurface {
    float gain;
    template <class T>
    struct Varyings {
        Vec3<T> normal;
        Vec2<T> uv;
    };
    static Varyings<float> vertex(const Vertex& v) { return {v.normal, v.uv}; }
    template <Real T>
    Rgb<T> operator()(const Varyings<T>& in) const {
        return gain * (in.normal + Vec3<T>(in.uv.x, in.uv.y, T(0.0F)));
    }
};
struct ShowFaintUv {
    float gain;
    template <class T>
    struct Varyings {
        Vec2<T> uv;
    };
    static Varyings<float> vertex(const Vertex& v) { return {v.uv}; }
    template <Real T>
    Rgb<T> operator()(const Varyings<T>& in) const {
        return gain * Rgb<T>(in.uv.x, in.uv.y, T(1.0F));
    }
};

// How uncertain a triangle's interpolants are, roughly, in units of float's precision: they are
// the steeper the thinner it is, and the more its depth varies.
double uncertainty(const ScreenTriangle& t) {
    const Edges edges = edges_of(t.v);
    double longest = 0;
    float near = 0;
    float far = t.v[0].inverse_w;
    for (std::size_t i = 0; i < 3; ++i) {
        const Edge& e = edges.edge[i];
        longest = std::max(longest, std::hypot(static_cast<double>(e.a), static_cast<double>(e.b)));
        near = std::max(near, t.v[i].inverse_w);
        far = std::min(far, t.v[i].inverse_w);
    }
    const double height = std::abs(static_cast<double>(edges.double_area)) / longest / subpixel_one;
    return edges.double_area == 0 ? 0 : (1 + 64 / height) * double{near / far};
}

// Materials by uncertainty, so that what is uncertain can be shown fainter; two of each.
constexpr int classes = 6;
void classify(RandomScene& scene, const View& view, Random& random) {
    Mesh& mesh = scene.mesh;
    mesh.materials.clear();
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
        mesh.materials.push_back(static_cast<std::uint16_t>(random.between(0, 1)));
    }
    for (const ScreenTriangle& t : assemble(mesh, view).triangles) {
        const double steps =
            std::clamp(std::log10(std::max(uncertainty(t), 1.0) / 32), 0.0, classes - 1.0);
        auto& material = mesh.materials[t.source];
        material =
            std::max(material, static_cast<std::uint16_t>(2 * std::ceil(steps) + material % 2));
    }
}

TEST_CASE("random scenes in pictures of awkward sizes") {
    std::vector<ShowSurface> surface;
    std::vector<ShowFaintUv> uv;
    for (int i = 0; i < classes; ++i) {
        surface.push_back({static_cast<float>(std::pow(10.0, -i))});
        uv.push_back({static_cast<float>(std::pow(10.0, -i))});
    }
    std::vector<Shader> shaders;
    for (std::size_t i = 0; i < classes; ++i) {
        shaders.push_back(plug(surface[i]));
        shaders.push_back(plug(uv[i]));
    }
    const std::vector<int> lanes = all_lanes();
    constexpr std::array<std::array<int, 2>, 10> sizes{{{1, 1},
                                                        {3, 5},
                                                        {63, 65},
                                                        {130, 70},
                                                        {64, 64},
                                                        {1, 129},
                                                        {200, 2},
                                                        {61, 7},
                                                        {65, 66},
                                                        {4, 4}}};
    for (std::uint64_t seed = 1; seed <= scenes; ++seed) {
        CAPTURE(seed);
        Random random(seed);
        const auto [width, height] = sizes[seed % sizes.size()];
        RandomScene scene = random_scene(seed);
        const View view{
            clip_from_world(scene.camera, static_cast<float>(width) / static_cast<float>(height)),
            width, height};
        classify(scene, view, random);
        const Settings settings{.samples = 1 << random.between(0, 4),
                                .sample_shading = random.one_in(2),
                                .cull = random.one_in(2) ? Cull::none : Cull::back};
        check_all_ways({scene.mesh, view, shaders, {0.25F, 0.5F, 0.75F}, 1e-5}, settings,
                       lanes[seed / 2 % lanes.size()]);
    }
}

}  // namespace
}  // namespace glint
