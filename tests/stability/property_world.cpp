#include "tests/stability/property_world.hpp"

#include "framework/geometry/shapes.hpp"
#include "tests/oracle/random.hpp"
#include "tests/pictures/random_scene.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace glint::stability {
namespace {

using oracle::Random;

float power_of_ten(Random& random, double low, double high) {
    return static_cast<float>(std::pow(10.0, random.real(low, high)));
}

Rgb<float> colour(Random& random) {
    const auto share = [&] { return static_cast<float>(random.real(0, 1)); };
    return random.one_in(4) ? Rgb<float>(static_cast<float>(random.between(0, 1)))
                            : Rgb<float>(share(), share(), share());
}

// Some hundreds of triangles, mostly fewer; a part of them of vertices without a usable normal.
void cut_down(Random& random, Mesh& mesh) {
    const double all = static_cast<double>(mesh.triangles.size());
    const auto kept = static_cast<std::ptrdiff_t>(std::pow(all, random.real(0, 1)));
    const auto first = random.between(0, static_cast<int>(mesh.triangles.size() - 1));
    std::rotate(mesh.triangles.begin(), mesh.triangles.begin() + first, mesh.triangles.end());
    mesh.triangles.erase(mesh.triangles.begin() + kept, mesh.triangles.end());
    const bool crippled = random.one_in(4);
    for (glm::vec3& normal : mesh.normals) {
        constexpr std::array lengths{0.0F, 1e-30F, 1e-12F, 1e25F};
        if (crippled && random.one_in(3)) {
            normal *= lengths[static_cast<std::size_t>(random.between(0, 3))];
        }
    }
}

// In half of the worlds: one solid that fills the picture, where rounding leaves colours no excuse.
void make_gentle(Random& random, World& world) {
    world.mesh = random.one_in(2) ? icosphere(1, random.between(0, 3))
                                  : torus(1, 0.4F, random.between(3, 20), random.between(3, 12));
    world.camera = {.eye = {random.real(-1, 1), random.real(-1, 1), random.real(2, 4)},
                    .target = {0, 0, 0},
                    .fov_degrees = 45,
                    .near = 0.3F,
                    .far = 10};
}

void light_up(Random& random, World& world) {
    const auto direction = [&] {
        const auto along = [&] { return static_cast<float>(random.real(-1, 1)); };
        return normalize_or(glm::vec3(along(), along(), along()), glm::vec3(0, 1, 0));
    };
    for (int i = random.between(1, random.one_in(10) ? 40 : 3); i > 0; --i) {
        world.lighting.directional.push_back(
            {direction(), colour(random) * power_of_ten(random, -2, 1.5)});
    }
    for (int i = random.between(0, 2); i > 0; --i) {
        const auto vertex = static_cast<std::size_t>(
            random.between(0, static_cast<int>(world.mesh.positions.size()) - 1));
        const bool touching = random.one_in(3);  // a light in the very place of a vertex
        world.lighting.point.push_back(
            {touching ? world.mesh.positions[vertex] : 4.0F * direction(),
             colour(random) * power_of_ten(random, -2, 2)});
    }
    world.lighting.ambient = random.one_in(2) ? Rgb<float>(0) : colour(random);
}

Surface surface(Random& random) {
    constexpr std::array special{0.0F, 1e-3F, 0.5F, 1.0F, 2.0F, 64.0F, 65.0F, 1e6F};
    const float n = random.one_in(3)
                        ? special[static_cast<std::size_t>(random.between(0, special.size() - 1))]
                        : power_of_ten(random, -1, 4);
    return {colour(random), random.one_in(3) ? 0.04F * colour(random) : colour(random), n};
}

}  // namespace

World random_world(std::uint64_t seed) {
    Random random(seed ^ 0x9e3779b97f4a7c15U);
    RandomScene scene = random_scene(seed);
    World world{.seed = seed, .mesh = std::move(scene.mesh), .camera = scene.camera};
    if (random.one_in(2)) {
        make_gentle(random, world);
    } else {
        cut_down(random, world.mesh);
        const glm::uvec3 seen = world.mesh.triangles[0];
        world.camera.target = (world.mesh.positions[seen.x] + world.mesh.positions[seen.y]) * 0.5F;
    }
    light_up(random, world);
    for (int i = random.between(1, 3); i > 0; --i) {
        world.surfaces.push_back(surface(random));
    }
    for (std::size_t i = 0; i < world.mesh.triangles.size(); ++i) {
        world.mesh.materials.push_back(static_cast<std::uint16_t>(
            random.between(0, static_cast<int>(world.surfaces.size()) - 1)));
    }
    world.model = static_cast<Model>(random.between(0, 3));
    world.width = random.between(1, 150);
    world.height = random.between(1, 100);
    world.settings.samples = random.one_in(3) ? 1 << random.between(1, 4) : 1;
    world.settings.sample_shading = random.one_in(2);
    world.settings.cull = random.one_in(2) ? Cull::none : Cull::back;
    return world;
}

double size_of(const World& world) {
    const auto things = world.mesh.triangles.size() + world.lighting.directional.size() +
                        world.lighting.point.size();
    return static_cast<double>(things) + 1e-5 * world.width * world.height;
}

std::string words(const World& world) {
    constexpr std::array models{"Lambert + Phong", "engine", "by angle", "consistent"};
    return std::to_string(world.mesh.triangles.size()) + " triangles, " +
           std::to_string(world.lighting.directional.size()) + " + " +
           std::to_string(world.lighting.point.size()) + " lights, model " +
           models[static_cast<std::size_t>(world.model)] +
           ", n = " + std::to_string(world.surfaces[0].n) + ", " + std::to_string(world.width) +
           "x" + std::to_string(world.height) + ", " + std::to_string(world.settings.samples) +
           " samples";
}

}  // namespace glint::stability
