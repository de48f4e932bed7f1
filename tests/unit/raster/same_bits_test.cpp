// Ids and depths are the same bits with every compiler and on every processor.
#include "framework/raster/plug.hpp"
#include "tests/oracle/random.hpp"
#include "tests/unit/raster/drawing.hpp"

#include <doctest/doctest.h>

#include <bit>
#include <cstdint>

namespace glint {
namespace {

using oracle::Random;

// Triangles before, behind and across the eye, some of them twice; no library function that may
// round in its own way has a hand in them.
Mesh crossing_triangles(Random& random) {
    const auto number = [&](int most) { return static_cast<float>(random.between(-most, most)); };
    Mesh mesh;
    for (std::uint32_t i = 0; i < 300; ++i) {
        const glm::vec3 place{number(4000), number(3000), number(6000)};
        const int size = random.one_in(10) ? 8000 : 700;
        for (int k = 0; k < 3; ++k) {
            const glm::vec3 away{number(size), number(size), number(size)};
            mesh.positions.push_back((place + away) / 999.0F);
        }
        mesh.triangles.emplace_back(3 * i, 3 * i + 1, 3 * i + 2);
        if (random.one_in(5)) {
            mesh.triangles.push_back(mesh.triangles.back());
        }
    }
    return mesh;
}

// From the origin towards -z, reversed depth.
View view_from_origin() {
    glm::mat4 clip_from_world(0.0F);
    clip_from_world[0][0] = 1.3F;
    clip_from_world[1][1] = 1.9F;
    clip_from_world[2][3] = -1.0F;
    clip_from_world[3][2] = 0.3F;
    return {clip_from_world, 190, 130};
}

// FNV-1a, http://www.isthe.com/chongo/tech/comp/fnv/
void add_to(std::uint64_t& digest, std::uint32_t bits) {
    for (int i = 0; i < 4; ++i) {
        digest = (digest ^ (bits >> 8 * i & 0xFFU)) * 0x100000001B3U;
    }
}

std::uint64_t digest_of(const Settings& settings) {
    std::uint64_t digest = 0xCBF29CE484222325U;
    for (std::uint64_t seed = 1; seed <= 8; ++seed) {
        Random random(seed);
        const Drawn d =
            draw(crossing_triangles(random), view_from_origin(), plug(show_position), settings);
        CHECK(d.statistics.fragments_shaded > 10000);
        for (const std::int32_t id : d.triangle.pixels()) {
            add_to(digest, static_cast<std::uint32_t>(id));
        }
        for (const float depth : d.depth.pixels()) {
            add_to(digest, std::bit_cast<std::uint32_t>(depth));
        }
    }
    return digest;
}

TEST_CASE("ids and depths have the digest that is recorded") {
    for (const auto& [samples, recorded] : {std::pair<int, std::uint64_t>{1, 4908181556475399547U},
                                            {4, 14858430620938312197U},
                                            {16, 10912952412324638448U}}) {
        for (const Settings& settings : both_rasterizers({.samples = samples})) {
            CAPTURE(words(settings));
            CHECK(digest_of(settings) == recorded);
        }
    }
}

}  // namespace
}  // namespace glint
