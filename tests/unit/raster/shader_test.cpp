#include "framework/raster/shader.hpp"

#include "framework/raster/plug.hpp"
#include "tests/unit/raster/drawing.hpp"
#include "tests/worst.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace glint {
namespace {

// N scalars of its own at each corner; shows a sum in which each has its weight.
template <int N>
struct Scalars {
    float gain = 1.0F;

    template <class T>
    struct Varyings {
        T value[N];
    };
    static Varyings<float> vertex(const Vertex& v) {
        Varyings<float> out{};
        for (int k = 0; k < N; ++k) {
            const auto n = static_cast<float>(k + 1);
            out.value[k] = n * v.position.x + v.position.y / n + v.uv.x * n * n;
        }
        return out;
    }
    template <Real T>
    Rgb<T> operator()(const Varyings<T>& in) const {
        T sum(0.0F);
        for (int k = 0; k < N; ++k) {
            sum += in.value[k] * T(1.0F / static_cast<float>(k + 1));
        }
        return {gain * sum, in.value[0], in.value[N - 1]};
    }
};

Mesh small_mesh() {
    return {.positions = {{1, 2, 0.5F}, {7, 1, 0.5F}, {3, 9, 0.5F}, {8, 8, 0.5F}},
            .normals = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0, 0.6F, 0.8F}},
            .uvs = {{0, 0}, {1, 0}, {0, 1}, {1, 1}},
            .triangles = {{0, 1, 2}, {1, 3, 2}},
            .materials = {}};
}

template <int N>
void check_scalars() {
    CAPTURE(N);
    const Scalars<N> shader{.gain = 2.0F};
    const Shader plugged = plug(shader);
    CHECK(plugged.varyings == N);
    CHECK(plugged.shader == &shader);
    CHECK((plugged.explain_float == nullptr));
    CHECK((plugged.explain_double == nullptr));
    CHECK((plugged.shade_8 != nullptr) == (max_lanes >= 8));
    CHECK((plugged.shade_16 != nullptr) == (max_lanes >= 16));

    // The vertex stage: of vertices in any order, side by side.
    const Mesh mesh = small_mesh();
    const std::uint32_t vertices[] = {2, 0, 3, 0};
    std::vector<float> values(5 * N, -1.0F);
    plugged.vertex(&shader, mesh, vertices, 4, 5, values.data());
    for (std::size_t i = 0; i < 4; ++i) {
        const auto at = vertices[i];
        const auto expected = shader.vertex({mesh.positions[at], mesh.normals[at], mesh.uvs[at]});
        for (std::size_t k = 0; k < N; ++k) {
            CHECK(values[5 * k + i] == expected.value[k]);
        }
    }
    for (std::size_t k = 0; k < N; ++k) {
        CHECK(values[5 * k + 4] == -1.0F);
    }

    // The fragment stage: all widths shade what the scalar call does, the reference in double.
    constexpr int count = 37;
    constexpr int stride = 48;
    std::vector<float> in(N * stride, 0.0F);
    std::vector<double> in_double(N * stride, 0.0);
    for (std::size_t i = 0; i < in.size(); ++i) {
        in[i] = std::sin(static_cast<float>(i));
        in_double[i] = in[i];
    }
    std::vector<float> expected(3 * stride, 0.0F);
    for (int i = 0; i < count; ++i) {
        typename Scalars<N>::template Varyings<float> v;
        for (int k = 0; k < N; ++k) {
            v.value[k] = in[static_cast<std::size_t>(k * stride + i)];
        }
        const Rgb<float> c = shader(v);
        for (int channel = 0; channel < 3; ++channel) {
            expected[static_cast<std::size_t>(channel * stride + i)] = c[channel];
        }
    }
    for (const auto call : {plugged.shade_1, plugged.shade_4, plugged.shade_8, plugged.shade_16}) {
        if (call == nullptr) {
            continue;
        }
        std::vector<float> out(3 * stride, 0.0F);
        call(&shader, in.data(), stride, count, out.data());
        double worst = 0;
        for (std::size_t i = 0; i < out.size(); ++i) {
            if (i % stride < count) {
                worst = worse(worst, std::abs(double{out[i]} - double{expected[i]}));
            }
        }
        CHECK(worst < 1e-6 * N);
    }
    std::vector<double> reference(3 * stride, 0.0);
    plugged.reference(&shader, in_double.data(), stride, count, reference.data());
    double worst = 0;
    for (std::size_t i = 0; i < reference.size(); ++i) {
        worst = worse(worst, std::abs(reference[i] - double{expected[i]}));
    }
    CHECK(worst < 1e-6 * N);
}

TEST_CASE("shaders of 1, 2, 3 and 16 varyings") {
    check_scalars<1>();
    check_scalars<2>();
    check_scalars<3>();
    check_scalars<max_varyings>();
}

// In a window view every varying is linear, so it is known at each pixel.
template <int N>
void check_picture() {
    CAPTURE(N);
    const Scalars<N> shader;
    Mesh mesh = small_mesh();
    mesh.uvs.clear();  // then uv is 0
    for (const Settings& settings : both_rasterizers({.threads = 2})) {
        CAPTURE(words(settings));
        const Drawn d = draw(mesh, window_view(10, 10), plug(shader), settings);
        int covered = 0;
        double worst = 0;
        for (int y = 0; y < 10; ++y) {
            for (int x = 0; x < 10; ++x) {
                if (d.triangle(x, y) != no_triangle) {
                    ++covered;
                    const auto v = shader.vertex({glm::vec3(x + 0.5, y + 0.5, 0), {}, {}});
                    const Rgb<float> difference = shader(v) - d.linear(x, y);
                    worst = worse(worst, double{length(difference)});
                }
            }
        }
        CHECK(covered > 20);
        CHECK(worst < 2e-5 * N);
    }
}

TEST_CASE("varyings of every number arrive interpolated") {
    check_picture<1>();
    check_picture<2>();
    check_picture<3>();
    check_picture<max_varyings>();
}

// Triangles of 3 to 9 pixels, drawn over two large ones; neighbours have different materials.
Mesh patchwork(int size) {
    Mesh mesh;
    const auto add = [&](glm::vec3 a, glm::vec3 b, glm::vec3 c) {
        const auto first = static_cast<std::uint32_t>(mesh.positions.size());
        mesh.materials.push_back(static_cast<std::uint16_t>(mesh.triangles.size() % 3));
        mesh.triangles.emplace_back(first, first + 1, first + 2);
        for (const glm::vec3& corner : {a, b, c}) {
            mesh.positions.push_back(corner);
        }
    };
    const auto far = static_cast<float>(3 * size);
    add({-9, -9, 0.1F}, {far, -9, 0.1F}, {-9, far, 0.1F});
    for (int y = 20; y < size; y += 9) {
        for (int x = 1; x < size; x += 7) {
            const glm::vec3 corner(x, y, 0.5F);
            add(corner, corner + glm::vec3(6, 1, 0), corner + glm::vec3(2, 8, 0));
            add(corner + glm::vec3(0, 4, 0), corner + glm::vec3(3, 7, 0), corner);
        }
    }
    add({-9, -9, 0.2F}, {far, -9, 0.2F}, {-9, 50, 0.2F});
    return mesh;
}

TEST_CASE("triangles side by side may have shaders of different varyings") {
    const Scalars<1> one;
    const Scalars<3> three;
    const Scalars<max_varyings> many;
    const Shader shaders[] = {plug(one), plug(three), plug(many)};
    constexpr int size = 150;
    const Mesh mesh = patchwork(size);
    for (const Settings& settings : both_rasterizers({.threads = 2})) {
        CAPTURE(words(settings));
        const Drawn d = draw(mesh, window_view(size, size), shaders, settings);
        std::array<int, 3> seen{};
        int wrong = 0;
        for (int y = 0; y < size; ++y) {
            for (int x = 0; x < size; ++x) {
                const auto material = mesh.materials.at(static_cast<std::size_t>(d.triangle(x, y)));
                const Vertex v{glm::vec3(x + 0.5, y + 0.5, 0), {}, {}};
                const Rgb<float> exact = material == 0   ? one(Scalars<1>::vertex(v))
                                         : material == 1 ? three(Scalars<3>::vertex(v))
                                                         : many(Scalars<max_varyings>::vertex(v));
                wrong += length(exact - d.linear(x, y)) < 1e-6F * length(exact) ? 0 : 1;
                ++seen[material];
            }
        }
        CHECK(wrong == 0);
        CHECK(*std::min_element(seen.begin(), seen.end()) > 2000);
    }
}

struct ShowNormal {
    template <class T>
    struct Varyings {
        Vec3<T> normal;
        Vec2<T> uv;
    };
    static Varyings<float> vertex(const Vertex& v) { return {v.normal, v.uv}; }
    template <Real T>
    Rgb<T> operator()(const Varyings<T>& in) const {
        return in.normal + Vec3<T>(in.uv.x, in.uv.y, T(0.0F));
    }
};

TEST_CASE("what a mesh lacks is zero") {
    const ShowNormal shader;
    Mesh mesh = small_mesh();
    mesh.normals.clear();
    mesh.uvs.clear();
    for (const Settings& settings : both_rasterizers()) {
        const Drawn d = draw(mesh, window_view(10, 10), plug(shader), settings, Rgb<float>(0.0F));
        CHECK(std::ranges::all_of(d.linear.pixels(),
                                  [](const auto& c) { return c == Rgb<float>(0.0F); }));
    }
}

TEST_CASE("each triangle is shaded by the shader of its material") {
    // Stripes of many materials, with varyings of different number, in tiles and across them.
    Mesh mesh;
    constexpr int stripes = 50;
    for (std::uint32_t i = 0; i < stripes; ++i) {
        const float x = 3 * static_cast<float>(i);
        for (const glm::vec2 corner :
             {glm::vec2(0, 0), glm::vec2(3, 0), glm::vec2(3, 70), glm::vec2(0, 70)}) {
            mesh.positions.emplace_back(x + corner.x, corner.y, 0.5F);
        }
        mesh.triangles.push_back({4 * i, 4 * i + 1, 4 * i + 2});
        mesh.triangles.push_back({4 * i, 4 * i + 2, 4 * i + 3});
        mesh.materials.push_back(static_cast<std::uint16_t>(i * 7 % 5));
        mesh.materials.push_back(static_cast<std::uint16_t>(i * 7 % 5));
    }
    const OneColour colours[] = {{Rgb<float>(1.0F)}, {Rgb<float>(2.0F)}, {Rgb<float>(3.0F)}};
    const Scalars<16> sixteen;
    const std::vector<Shader> shaders{plug(colours[0]), plug(sixteen), plug(colours[1]),
                                      plug(show_position), plug(colours[2])};
    for (const int threads : {1, 2}) {
        for (const Settings& settings : both_rasterizers({.threads = threads})) {
            CAPTURE(words(settings));
            const Drawn d = draw(mesh, window_view(150, 70), shaders, settings, {9, 9, 9});
            double worst = 0;
            for (int y = 0; y < 70; ++y) {
                for (int x = 0; x < 150; ++x) {
                    const glm::vec3 at(x + 0.5, y + 0.5, 0.5);
                    const Rgb<float> by_material[] = {
                        colours[0].colour, sixteen(decltype(sixteen)::vertex({at, {}, {}})),
                        colours[1].colour, at, colours[2].colour};
                    const Rgb<float> expected = by_material[x / 3 * 7 % 5];
                    worst = worse(worst, double{length(d.linear(x, y) - expected)} /
                                             (1 + double{length(expected)}));
                }
            }
            CHECK(worst < 1e-5);
            CHECK(d.statistics.triangles_visible == 2 * stripes);
        }
    }
}

struct Commented {
    float factor = 3.0F;
    template <class T>
    struct Varyings {
        Vec2<T> uv;
    };
    static Varyings<float> vertex(const Vertex& v) { return {v.uv}; }
    template <Real T, class Noting = Silent>
    Rgb<T> operator()(const Varyings<T>& in, const Noting& note = {}) const {
        note("third", in.uv.x / T(3.0F));
        const Rgb<T> all(in.uv.x, in.uv.y, factor * in.uv.x);
        note("all", all);
        return all;
    }
};

TEST_CASE("a shader that takes a commentator names its terms, in float and in double") {
    const Commented shader;
    const Shader plugged = plug(shader);
    REQUIRE((plugged.explain_float != nullptr));
    REQUIRE((plugged.explain_double != nullptr));
    const float in_float[] = {1.0F, 0.5F};
    const double in_double[] = {1.0, 0.5};
    std::vector<Note> f;
    std::vector<Note> d;
    plugged.explain_float(&shader, in_float, f);
    plugged.explain_double(&shader, in_double, d);
    for (const auto& notes : {f, d}) {
        REQUIRE(notes.size() == 2);
        CHECK(notes[0].name == "third");
        CHECK(notes[0].components == 1);
        CHECK(notes[1].name == "all");
        CHECK(notes[1].components == 3);
        CHECK(notes[1].value == std::array{1.0, 0.5, 3.0});
    }
    CHECK(f[0].value[0] == double{1.0F / 3.0F});
    CHECK(d[0].value[0] == 1.0 / 3.0);
    // In pictures it is silent and the same.
    const Drawn drawn = draw(small_mesh(), window_view(10, 10), plugged, {});
    CHECK(drawn.linear(4, 4).b == doctest::Approx(3 * drawn.linear(4, 4).r));
    CHECK(drawn.linear(4, 4).r > 0);
}

}  // namespace
}  // namespace glint
