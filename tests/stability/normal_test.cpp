// Directions: normals that vanish, that are too short or too long, that look away.
#include "lessons/04_rendering_equation/rendering_equation.hpp"
#include "lessons/09_normalised_phong/normalised_phong.hpp"
#include "lessons/12_schlick/schlick.hpp"
#include "lessons/16_where_it_fails/consistent_phong.hpp"
#include "framework/scene/camera.hpp"
#include "framework/raster/plug.hpp"
#include "framework/geometry/shapes.hpp"
#include "tests/oracle/random.hpp"
#include "tests/stability/row.hpp"
#include "tests/unit/raster/drawing.hpp"

#include <algorithm>

namespace glint::stability {
namespace {

template <Real T>
Vec3<T> vec(double x, double y, double z) {
    return Vec3<T>(T(x), T(y), T(z));
}

TEST_CASE("normalising a normal of length 0") {
    const Lighting lighting{.directional = {{}}, .point = {}, .ambient = Rgb<float>(0.5F)};
    const Lit<NormalisedLambert> lit{{Rgb<float>(0.8F)}, lighting, {0, 0, 3}};
    row(in_all_numbers([&]<Real T>() {
            // Half way between two corners whose normals are opposite.
            const Vec3<T> N = mix(vec<T>(0, 0.6, 0.8), vec<T>(0, -0.6, -0.8), T(0.5F));
            const T naive = T(0.4F) + T(0.8F) * inverse_pi<T> * max(normalize(N).z, T(-1.0F));
            const Rgb<T> glint = lit(Lit<NormalisedLambert>::Varyings<T>{vec<T>(0, 0, 0), N});
            return Errors{std::isnan(value(normalize(N).z)) ? nan : value(naive) - 0.4,
                          std::abs(value(glint.g) - 0.4)};
        }),
        infinite, 1e-7);
}

struct ShowNormal {
    template <class T>
    struct Varyings {
        Vec3<T> normal;
    };
    static Varyings<float> vertex(const Vertex& v) { return {v.normal}; }
    template <Real T>
    Rgb<T> operator()(const Varyings<T>& in) const {
        return in.normal;
    }
};
constexpr int side = 64;

void draw_highlights() {
    const Camera camera{.eye = {0, 0, 3}, .target = {0, 0, 0}, .fov_degrees = 40};
    const ShowNormal show;
    const auto normal =
        draw(icosphere(1, 1), {clip_from_world(camera, 1), side, side}, plug(show), {}).linear;
    const auto shade = [&](bool unit) {
        return [&, unit](int x, int y) {
            const glm::vec3 N = unit ? normalize_or(normal(x, y), glm::vec3(0)) : normal(x, y);
            const float cosine = std::max(dot(N, normalize(glm::vec3(-0.3F, 0.4F, 1))), 0.0F);
            return Rgb<float>(0.1F * cosine + 0.7F * pow(cosine, 40.0F));
        };
    };
    picture("short_normals", side, side, 3, shade(false), shade(true));
}

TEST_CASE("interpolated normals as they are: corners that look 160 degrees apart") {
    draw_highlights();
    row(in_all_numbers([]<Real T>() {
            const double a = 80 * pi / 180;
            const Vec3<T> N = mix(vec<T>(std::sin(a), 0, std::cos(a)),
                                  vec<T>(-std::sin(a), 0, std::cos(a)), T(0.5F));
            const Vec3<T> L = vec<T>(0, 0, 1);
            return Errors{std::abs(value(dot(N, L)) - 1),
                          std::abs(value(dot(normalize_or(N, L), L)) - 1)};
        }),
        0.8, 2e-7);
}

TEST_CASE("normalising vectors of length 1e-30 and 1e30") {
    row(in_floats([]<Real T>() {
            Errors worst;
            for (const double size : {1e-30, 1e30}) {
                const Vec3<T> v = vec<T>(0.6 * size, 0, 0.8 * size);
                const auto off = [](const Vec3<T>& unit) {
                    return std::abs(value(length(unit)) - 1);
                };
                add(worst, {off(v / sqrt(dot(v, v))), off(normalize_or(v, vec<T>(0, 1, 0)))});
            }
            return worst;
        }),
        1, 0);
    const Vec3<double> v(0.6e-30, 0, 0.8e30);  // a double has room for both
    CHECK(length(normalize_or(v, Vec3<double>(0, 1, 0))) == doctest::Approx(1));
}

struct ShowCosine {  // N.V
    glm::vec3 eye;
    template <class T>
    struct Varyings {
        Vec3<T> position, normal;
    };
    static Varyings<float> vertex(const Vertex& v) { return {v.position, v.normal}; }
    template <Real T>
    Rgb<T> operator()(const Varyings<T>& in) const {
        return Rgb<T>(dot(normalize(in.normal), normalize(eye - in.position)));
    }
};

TEST_CASE("N.V below 0: Schlick's reflectance on silhouettes") {
    const auto printed = [](auto cosine) {
        const auto m = 1 - cosine;
        return 0.04 + 0.96 * m * m * m * m * m;
    };
    // A coarse sphere: interpolated normals at the rim look away from the viewer.
    const Mesh ball = sphere(1, 8, 5);
    const Camera camera{.eye = {0, 0, 3}, .target = {0, 0, 0}, .fov_degrees = 40};
    const ShowCosine show{camera.eye};
    const View view{clip_from_world(camera, 1), side, side};
    const auto cosine = draw(ball, view, plug(show), {}, Rgb<float>(1)).linear;
    picture(
        "silhouette", side, side, 3,
        [&](int x, int y) {
            const double F = printed(double{cosine(x, y).g});
            return F > 1 ? Rgb<float>(1, 0, 0.5F) : Rgb<float>(static_cast<float>(F));
        },
        [&](int x, int y) { return Rgb<float>(schlick(0.04F, cosine(x, y).g)); });
    row(in_all_numbers([&]<Real T>() {
            const Drawn d = draw(ball, view, plug(show), settings_of<T>(), Rgb<float>(1));
            Errors above;  // 1
            for (const Rgb<float>& c : d.linear.pixels()) {
                add(above, {printed(double{c.g}) - 1, value(schlick(T(0.04F), T(c.g))) - 1});
            }
            return above;
        }),
        0.5, 0);
}

TEST_CASE("N.V below 0: the coupled diffuse part") {
    row(in_all_numbers([]<Real T>() {
            const Incidence<T> g{T(0.5F), T(-0.9F), T(0.0F)};
            const T m = T(1.0F) - g.NV;
            const T naive = T(1.0F) - m * m * m * m * m;  // a share that leaves
            const Rgb<T> white(T(1.0F));
            const T glint = coupled_diffuse(white, Rgb<T>(T(0.0F)), g).g;
            return Errors{-value(naive), std::max(-value(glint), 0.0)};
        }),
        20, 0);
}

TEST_CASE("V.R by cosines at the peak of a highlight, n = 2048") {
    row(in_floats([]<Real T>() {
            const double n = 2048;
            oracle::Random random(1);
            const auto direction = [&] {
                return normalize_or(
                    glm::dvec3(random.real(-1, 1), random.real(-1, 1), random.real(-1, 1)),
                    glm::dvec3(0, 0, 1));
            };
            const auto rounded = [](const glm::dvec3& v) {
                return normalize(vec<T>(v.x, v.y, v.z));
            };
            Errors worst;
            for (int i = 0; i < 3000; ++i) {
                const glm::dvec3 N = direction();
                const glm::dvec3 L = direction();
                const glm::dvec3 V = normalize(2 * dot(N, L) * N - L + 0.02 * direction());
                const double exact = pow(v_dot_r(incidence(N, L, V)), n);
                const Incidence<T> g = incidence(rounded(N), rounded(L), rounded(V));
                add(worst, {std::abs(value(pow(v_dot_r_by_cosines(g), T(n))) - exact),
                            std::abs(value(phong_lobe(g, T(n))) - exact)});
            }
            return worst;
        }),
        2e-4, 1e-4);
}

TEST_CASE("V.R a hair above 1") {
    row(in_all_numbers([]<Real T>() {
            oracle::Random random(1);
            Errors worst;
            for (int i = 0; i < 3000; ++i) {
                const Vec3<T> N =
                    normalize_or(vec<T>(random.real(-1, 1), random.real(-1, 1), random.real(-1, 1)),
                                 vec<T>(0, 0, 1));
                const Incidence<T> g = incidence(N, N, N);
                add(worst, {value(pow(v_dot_r_by_cosines(g), T(1e6F))) - 1,
                            value(phong_lobe(g, T(1e6F))) - 1});
            }
            return worst;
        }),
        0.4, 0);
}

}  // namespace
}  // namespace glint::stability
