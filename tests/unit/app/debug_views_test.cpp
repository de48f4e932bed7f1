#include "framework/app/debug_views.hpp"

#include "tests/unit/raster/drawing.hpp"

#include <doctest/doctest.h>

#include <set>
#include <tuple>

namespace glint {
namespace {

constexpr Rgba8 black{0, 0, 0, 255};

TEST_CASE("normals are colours, a missing one is grey") {
    const NormalView shader;
    const auto seen = [&](const glm::vec3& n) { return shader(NormalView::Varyings<float>{n}); };
    CHECK(seen({0, 0, 2}) == glm::vec3(0.5F, 0.5F, 1));
    CHECK(seen({-3, 0, 0}) == glm::vec3(0, 0.5F, 0.5F));
    CHECK(seen({0, 0, 0}) == glm::vec3(0.5F));
    CHECK(shader(NormalView::Varyings<double>{{0, 1, 0}}) == glm::dvec3(0.5, 1, 0.5));
}

TEST_CASE("near is bright, far is dark, nothing is black") {
    Image<float> depth(4, 1, 0.0F);
    depth(1, 0) = 0.9F;
    depth(2, 0) = 0.09F;
    depth(3, 0) = 0.009F;
    const SrgbImage picture = depth_picture(depth);
    CHECK(picture(0, 0) == black);
    CHECK(picture(1, 0).r == 255);
    CHECK(picture(3, 0).r == 40);
    CHECK(picture(2, 0).r == 147);  // half way by ratio
    CHECK(picture(2, 0).g == picture(2, 0).r);
}

TEST_CASE("depths that are all equal, or none, are no trouble") {
    CHECK(depth_picture(Image<float>(2, 2, 0.0F)) == SrgbImage(2, 2, black));
    const SrgbImage flat = depth_picture(Image<float>(2, 2, 0.5F));
    CHECK(flat(0, 0).r >= 40);
    CHECK(flat == SrgbImage(2, 2, flat(0, 0)));
}

TEST_CASE("triangles have colours of their own") {
    Image<std::int32_t> numbers(1001, 1);
    for (int i = 0; i <= 1000; ++i) {
        numbers(i, 0) = i - 1;
    }
    const SrgbImage picture = triangle_picture(numbers);
    CHECK(picture(0, 0) == black);
    std::set<std::tuple<int, int, int>> colours;
    for (int i = 1; i <= 1000; ++i) {
        const Rgba8 c = picture(i, 0);
        colours.insert({c.r, c.g, c.b});
        CHECK(c.r + c.g + c.b >= 3 * 64);
    }
    CHECK(colours.size() > 990);
    CHECK(as_floats(numbers)(0, 0) == -1.0F);
    CHECK(as_floats(numbers)(1000, 0) == 999.0F);
}

// Layer i covers columns i.. of the window.
Mesh layers(int count) {
    Mesh mesh;
    for (int i = 0; i < count; ++i) {
        const auto x = static_cast<float>(i);
        const auto first = static_cast<std::uint32_t>(mesh.positions.size());
        for (const glm::vec2 corner :
             {glm::vec2(x, 0), glm::vec2(x, 100), glm::vec2(100, 100), glm::vec2(100, 0)}) {
            mesh.positions.emplace_back(corner.x, corner.y, 0.9F - 0.1F * x);
        }
        mesh.triangles.emplace_back(first, first + 1, first + 2);
        mesh.triangles.emplace_back(first, first + 2, first + 3);
    }
    return mesh;
}

TEST_CASE("overdraw counts every layer, hidden ones too") {
    const View view = window_view(100, 100);
    for (const Cull cull : {Cull::none, Cull::back}) {
        const Image<float> count = overdraw(layers(5), view, cull);
        CHECK(count(0, 50) == 1.0F);
        CHECK(count(2, 50) == 3.0F);
        CHECK(count(99, 50) == 5.0F);
    }
    Mesh turned = layers(5);
    for (glm::uvec3& t : turned.triangles) {
        t = {t.z, t.y, t.x};
    }
    CHECK(overdraw(turned, view, Cull::none)(99, 50) == 5.0F);
    CHECK(overdraw(turned, view, Cull::back)(99, 50) == 0.0F);
    const SrgbImage picture = count_picture(overdraw(layers(5), window_view(300, 100), Cull::none));
    CHECK(picture(299, 0) == black);
    CHECK(picture(0, 0) != black);
    CHECK(picture(0, 0) != picture(99, 0));
    CHECK(count_picture(Image<float>(3, 3, 0.0F)) == SrgbImage(3, 3, black));
}

TEST_CASE("each tile's count of triangles") {
    const View view = window_view(200, 100);
    for (const int lanes : all_lanes()) {
        const Image<float> count = triangles_by_tile(layers(5), view, {.lanes = lanes});
        CHECK(count(0, 0) == count(63, 63));
        CHECK(count(0, 0) >= 5.0F);
        CHECK(count(0, 0) <= 10.0F);
        CHECK(count(199, 99) == 0.0F);
    }
    const SrgbImage picture = tile_picture(triangles_by_tile(layers(5), view, {}));
    CHECK(picture(64, 10) == picture(128, 50));  // lines between tiles
    CHECK(picture(64, 10) != picture(65, 10));
    CHECK(picture(199, 99) == black);
}

}  // namespace
}  // namespace glint
