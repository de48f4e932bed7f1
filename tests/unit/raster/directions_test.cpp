// Shaders that ask for directions only.
#include "framework/scene/camera.hpp"
#include "framework/raster/plug.hpp"
#include "tests/unit/raster/drawing.hpp"
#include "tests/worst.hpp"

#include <doctest/doctest.h>

#include <random>

namespace glint {
namespace {

template <bool only>
struct ShowDirections {
    static constexpr bool directions_only = only;
    template <class T>
    struct Varyings {
        Vec3<T> position, normal;
    };
    static Varyings<float> vertex(const Vertex& v) { return {v.position, v.normal}; }
    template <Real T>
    Rgb<T> operator()(const Varyings<T>& in) const {
        return normalize(in.position) + T(0.5F) * normalize_or(in.normal, Vec3<T>(T(0.0F)));
    }
};

// Triangles of all sizes before, behind and through the eye at (0, 0, 0.5), turned any way; some
// have no normals.
Mesh random_mesh() {
    Mesh mesh;
    std::mt19937 random(7);
    std::uniform_real_distribution<float> any(-1, 1);
    const auto anywhere = [&] { return glm::vec3{any(random), any(random), any(random)}; };
    for (std::uint32_t i = 0; i < 3000; ++i) {
        const float size = std::exp2(-9 * std::abs(any(random)));
        const glm::vec3 middle = 3.0F * anywhere();
        const glm::vec3 normal = i % 16 == 0 ? glm::vec3(0) : anywhere();
        for (int corner = 0; corner < 3; ++corner) {
            mesh.positions.push_back(middle + size * anywhere());
            mesh.normals.push_back(normal + 0.3F * length(normal) * anywhere());
        }
        mesh.triangles.emplace_back(3 * i, 3 * i + 1, 3 * i + 2);
    }
    return mesh;
}

TEST_CASE("directions need no quotient by 1/w") {
    const Mesh mesh = random_mesh();
    const Camera camera{.eye = {0, 0, 0.5F}, .fov_degrees = 70, .near = 1e-3F};
    const View view{clip_from_world(camera, 2), 300, 150};
    const ShowDirections<false> exact;
    const ShowDirections<true> only;
    CHECK(plug(only).directions_only);
    CHECK(!plug(exact).directions_only);
    for (const int samples : {1, 4}) {
        for (const Settings& settings : both_rasterizers({.threads = 2, .samples = samples})) {
            CAPTURE(words(settings));
            const Drawn a = draw(mesh, view, plug(exact), settings);
            const Drawn b = draw(mesh, view, plug(only), settings);
            REQUIRE(a.statistics.triangles_visible > 50);
            double worst = 0;
            for (std::size_t i = 0; i < a.linear.pixels().size(); ++i) {
                worst = worse(worst, length(a.linear.pixels()[i] - b.linear.pixels()[i]));
            }
            CHECK(worst < 1e-5);
        }
    }
}

}  // namespace
}  // namespace glint
