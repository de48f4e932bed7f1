#include "framework/scene/stages.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <set>

namespace glint {
namespace {

struct Stage {
    const char* name;
    Scene (*make)();
};
constexpr Stage all_stages[] = {{"still life", stages::still_life},
                                {"still life, upright", stages::still_life_upright},
                                {"three lamps", [] {
                                     Scene s = stages::still_life_upright();
                                     s.lighting = stages::three_lamps();
                                     return s;
                                 }}};

TEST_CASE("every stage can be drawn") {
    for (const Stage& stage : all_stages) {
        CAPTURE(stage.name);
        const Scene s = stage.make();
        const Mesh& mesh = s.mesh;
        REQUIRE(!mesh.triangles.empty());
        CHECK_NOTHROW(clip_from_world(s.camera, 1.7778F));
        CHECK(mesh.normals.size() == mesh.positions.size());
        CHECK((mesh.uvs.empty() || mesh.uvs.size() == mesh.positions.size()));
        CHECK((mesh.materials.empty() || mesh.materials.size() == mesh.triangles.size()));
        for (const glm::uvec3& t : mesh.triangles) {
            REQUIRE(std::max({t.x, t.y, t.z}) < mesh.positions.size());
        }
        for (const glm::vec3& n : mesh.normals) {
            REQUIRE(std::abs(length(n) - 1) < 1e-5F);
        }
        std::set<std::uint16_t> used(mesh.materials.begin(), mesh.materials.end());
        CHECK((used.empty() ? 0 : *used.rbegin()) < s.materials.size());
        CHECK(std::max<std::size_t>(used.size(), 1) == s.materials.size());  // none for nothing
    }
}

TEST_CASE("every stage is lit, by lights as they are meant to be") {
    for (const Stage& stage : all_stages) {
        CAPTURE(stage.name);
        const Scene s = stage.make();
        CHECK(s.lighting.directional.size() + s.lighting.point.size() > 0);
        for (const DirectionalLight& light : s.lighting.directional) {
            CHECK(std::abs(length(light.direction) - 1) < 1e-6F);
            CHECK(std::min({light.irradiance.r, light.irradiance.g, light.irradiance.b}) >= 0);
        }
        for (const PointLight& light : s.lighting.point) {
            CHECK(std::min({light.intensity.r, light.intensity.g, light.intensity.b}) >= 0);
        }
    }
}

TEST_CASE("every stage is of plausible materials") {
    for (const Stage& stage : all_stages) {
        std::set<std::string> names;
        for (const Material& m : stage.make().materials) {
            CAPTURE(m.name);
            CHECK(names.insert(m.name).second);
            for (int k = 0; k < 3; ++k) {
                CHECK(m.diffuse[k] >= 0);
                CHECK(m.diffuse[k] <= 1);
                CHECK(m.specular[k] >= 0);
                CHECK(m.specular[k] <= 1);
            }
            CHECK(m.exponent >= 0);
            CHECK(m.ior > 0);
        }
    }
}

}  // namespace
}  // namespace glint
