// The same picture every time: contraction, subnormal numbers, threads.
#include "lessons/15_engine_integration/engine_phong.hpp"
#include "framework/scene/camera.hpp"
#include "framework/raster/assemble.hpp"
#include "framework/raster/plug.hpp"
#include "framework/raster/setup.hpp"
#include "framework/geometry/shapes.hpp"
#include "tests/pictures/random_scene.hpp"
#include "tests/stability/contracted.hpp"
#include "tests/stability/row.hpp"
#include "tests/unit/raster/drawing.hpp"

#include <algorithm>
#include <numeric>

namespace glint::stability {
namespace {

constexpr int side = 96;

template <class Pixel, class Differ>
double count(const Image<Pixel>& a, const Image<Pixel>& b, Differ differ) {
    return std::inner_product(
        a.pixels().begin(), a.pixels().end(), b.pixels().begin(), 0.0, std::plus<>(),
        [&](const Pixel& p, const Pixel& q) { return differ(p, q) ? 1.0 : 0.0; });
}

TEST_CASE("contraction of the depth plane: a copy of what is there already") {
    const Camera camera{.eye = {0.3F, 1, 3}, .target = {0, 0, 0}, .up = {0.3F, 1, 0}};
    const View view{clip_from_world(camera, 1), side, side};
    const Mesh floor = plane(4, 4, 1, 1);
    const std::vector<ScreenTriangle> triangles = assemble(floor, view).triangles;
    const auto depth = [&]<Real T>(int triangle, int x, int y, bool contracted) {
        const auto& v = triangles[static_cast<std::size_t>(triangle)].v;
        const DepthPlane<float> p = depth_plane(v, edges_of(v).double_area);
        const T px = T(static_cast<float>(x) + 0.5F) - T(p.x);
        const T py = T(static_cast<float>(y) + 0.5F) - T(p.y);
        const T down = T(p.dzdy) * py;
        const T slope = contracted ? T(static_cast<float>(double{p.dzdx} * value(px) + value(down)))
                                   : T(p.dzdx) * px + down;
        return static_cast<float>(value(min(max(T(p.z) + slope, T(p.low)), T(p.high))));
    };
    row(in_floats([&]<Real T>() {
            const Drawn d = draw(floor, view, plug(show_uv), settings_of<T>());
            Errors differ;
            for (int y = 0; y < side; ++y) {
                for (int x = 0; x < side; ++x) {
                    if (const int t = d.triangle(x, y); t >= 0) {
                        differ.naive +=
                            depth.template operator()<T>(t, x, y, true) != d.depth(x, y) ? 1 : 0;
                        differ.glint +=
                            depth.template operator()<T>(t, x, y, false) != d.depth(x, y) ? 1 : 0;
                    }
                }
            }
            return differ;
        }),
        300, 0);
}

TEST_CASE("contraction of shading: bits, and codes") {
    const float x = 1 + 0x1p-12F;
    const bool contracts = fma(x, x, -1.0F) != 0x1p-11F;  // not every processor can
    const Lighting lighting{.directional = {{normalize(glm::vec3(1, 1, 1)), Rgb<float>(3)}},
                            .point = {},
                            .ambient = Rgb<float>(0.1F)};
    const EnginePhong phong{Rgb<float>(0.5F, 0.3F, 0.2F), Rgb<float>(0.04F), 80};
    const Camera camera{.eye = {0, 0.3F, 3}, .target = {0, 0, 0}};
    const View view{clip_from_world(camera, 1), side, side};
    const Mesh ball = icosphere(1, 3);
    const Lit<Contracted> fused{{phong}, lighting, camera.eye};
    const Lit<EnginePhong> plain{phong, lighting, camera.eye};
    row(in_all_numbers([&]<Real T>() {
            const Drawn a = draw(ball, view, plug_contracted(fused), settings_of<T>());
            const Drawn b = draw(ball, view, plug(plain), settings_of<T>());
            Errors e{count(a.linear, b.linear, std::not_equal_to<>()), 0};
            for (std::size_t i = 0; i < a.srgb.pixels().size(); ++i) {
                const Rgba8 p = a.srgb.pixels()[i];
                const Rgba8 q = b.srgb.pixels()[i];
                e.glint = std::max({e.glint, std::abs(1.0 * p.r - q.r), std::abs(1.0 * p.g - q.g),
                                    std::abs(1.0 * p.b - q.b)});
            }
            return e;
        }),
        contracts ? 50 : 0, 1);
}

struct Fading {  // a lobe that leaves the range of normal numbers
    template <class T>
    struct Varyings {
        Vec2<T> uv;
    };
    static Varyings<float> vertex(const Vertex& v) { return {v.uv}; }
    template <Real T>
    Rgb<T> operator()(const Varyings<T>& in) const {
        return Rgb<T>(pow(T(1.0F) - in.uv.x, T(99.5F)));
    }
};

// 1/(x - y) where x > y, which is 2^127; compiled as a function that is asked each time.
volatile float larger = 0x1.8p-126F;
volatile float smaller = 0x1p-126F;
template <Real T>
[[gnu::noinline]] double guarded_quotient() {
    const T x = T(float{larger});
    const T y = T(float{smaller});
    return value(select(x > y, T(1.0F) / (x - y), T(0.0F)));
}

TEST_CASE("subnormal numbers flushed to 0: a difference as divisor, a highlight that fades") {
    const Camera camera{.eye = {0, 3, 0}, .target = {0, 0, 0}, .up = {0, 0, -1}};
    const View view{clip_from_world(camera, 1), side, side};
    const Mesh square = plane(2.4F, 2.4F, 1, 1);
    const Fading fading;
    const Drawn exact = draw(square, view, plug(fading), {.rasterizer = Rasterizer::scanline});
    row(in_floats([&]<Real T>() {
            Errors e;
            {
                const FlushSubnormals flush;
                e.naive = guarded_quotient<T>();
            }
            CHECK(guarded_quotient<T>() < 2e38);
            const Drawn flushed = draw(square, view, plug(fading), settings_of<T>());
            CHECK(flushed.srgb == exact.srgb);
            for (std::size_t i = 0; i < exact.linear.pixels().size(); ++i) {
                const double a = double{exact.linear.pixels()[i].g};
                const double b = double{flushed.linear.pixels()[i].g};
                e.glint = a < 1e-37 ? std::max(e.glint, std::abs(a - b)) : e.glint;
            }
            return e;
        }),
        infinite, 1e-37);
}

TEST_CASE("threads that finish in another order: faces of equal depth") {
    // As threads without a rule would leave it: of equals the last to come wins.
    const auto last_wins = [](const Mesh& mesh, const View& view, bool backwards) {
        Image<std::int32_t> winner(side, side, no_triangle);
        Image<float> depth(side, side);
        Mesh alone = mesh;
        for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
            const std::size_t t = backwards ? mesh.triangles.size() - 1 - i : i;
            alone.triangles = {mesh.triangles[t]};
            const Drawn d = draw(alone, view, plug(show_uv), {});
            for (std::size_t p = 0; p < winner.pixels().size(); ++p) {
                if (d.triangle.pixels()[p] == 0 && d.depth.pixels()[p] >= depth.pixels()[p]) {
                    winner.pixels()[p] = static_cast<std::int32_t>(t);
                    depth.pixels()[p] = d.depth.pixels()[p];
                }
            }
        }
        return winner;
    };
    RandomScene scene = random_scene(3);
    const View view{clip_from_world(scene.camera, 1), side, side};
    LineVector<glm::uvec3>& triangles = scene.mesh.triangles;
    triangles.resize(std::min<std::size_t>(triangles.size(), 60));
    const LineVector<glm::uvec3> copies = triangles;
    triangles.insert(triangles.end(), copies.begin(), copies.begin() + 30);
    const double naive = count(last_wins(scene.mesh, view, false),
                               last_wins(scene.mesh, view, true), std::not_equal_to<>());
    row(in_floats([&]<Real T>() {
            Settings settings = settings_of<T>();
            const Drawn one = draw(scene.mesh, view, plug(show_uv), settings);
            Errors e{naive, 0};
            for (const int threads : {2, 3, 7}) {
                settings.threads = threads;
                const Drawn many = draw(scene.mesh, view, plug(show_uv), settings);
                e.glint += count(one.triangle, many.triangle, std::not_equal_to<>()) +
                           count(one.linear, many.linear, std::not_equal_to<>());
            }
            return e;
        }),
        200, 0);
}

}  // namespace
}  // namespace glint::stability
