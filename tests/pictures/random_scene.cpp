#include "tests/pictures/random_scene.hpp"

#include "framework/geometry/shapes.hpp"
#include "tests/oracle/random.hpp"

#include <glm/gtc/matrix_transform.hpp>

#include <cmath>

namespace glint {
namespace {

using oracle::Random;

glm::vec3 within(Random& random, double size) {
    return {random.real(-size, size), random.real(-size, size), random.real(-size, size)};
}

glm::vec3 any_direction(Random& random) {
    return normalize_or(within(random, 1), glm::vec3(0, 1, 0));
}

void add_triangle(Random& random, Mesh& mesh) {
    const double size = std::pow(10.0, random.real(-2, 1));
    const glm::vec3 centre = within(random, 4);
    glm::vec3 corner[3];
    for (glm::vec3& c : corner) {
        c = centre + within(random, size);
    }
    if (random.one_in(8)) {  // a sliver
        corner[2] = corner[1] + within(random, 0.01 * size);
    }
    const auto first = static_cast<std::uint32_t>(mesh.positions.size());
    for (const glm::vec3& c : corner) {
        mesh.positions.push_back(c);
        mesh.normals.push_back(any_direction(random));
        mesh.uvs.emplace_back(random.real(0, 1), random.real(0, 1));
    }
    mesh.triangles.emplace_back(first, first + 1, first + 2);
}

Mesh any_solid(Random& random) {
    switch (random.between(0, 2)) {
        case 0:
            return icosphere(1, random.between(0, 3));
        case 1:
            return sphere(1, random.between(3, 40), random.between(2, 20));
        default:
            return box({1, 2, 3});
    }
}

Mesh placed(Random& random, const Mesh& mesh) {
    glm::mat4 m = glm::translate(glm::mat4(1.0F), within(random, 4));
    m = glm::rotate(m, static_cast<float>(random.real(0, 6)), any_direction(random));
    const auto scale = static_cast<float>(std::pow(2.0, random.real(-3, 3)));
    return transform(mesh, glm::scale(m, glm::vec3(scale)));
}

void add_copies(Random& random, Mesh& mesh) {
    const int count = static_cast<int>(mesh.triangles.size());
    for (int i = random.between(0, count); i > 0; --i) {
        mesh.triangles.push_back(
            mesh.triangles[static_cast<std::size_t>(random.between(0, count - 1))]);
    }
}

}  // namespace

RandomScene random_scene(std::uint64_t seed) {
    Random random(seed);
    RandomScene s;
    for (int i = random.between(1, 300); i > 0; --i) {
        add_triangle(random, s.mesh);
    }
    for (int i = random.between(0, 3); i > 0; --i) {
        append(s.mesh, placed(random, any_solid(random)));
    }
    add_copies(random, s.mesh);
    s.mesh.materials.clear();
    s.camera = {.eye = within(random, 3),
                .target = within(random, 3),
                .up = within(random, 1),
                .fov_degrees = static_cast<float>(random.real(20, 110)),
                .near = 0.3F,
                .far = static_cast<float>(random.real(3, 50))};
    return s;
}

}  // namespace glint
