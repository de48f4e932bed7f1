#include "framework/raster/assemble.hpp"

#include "framework/raster/clip.hpp"
#include "framework/raster/transform.hpp"
#include "framework/geometry/mesh.hpp"

namespace glint {

Assembly assemble(const Mesh& mesh, const View& view) {
    const std::size_t count = mesh.positions.size();
    VertexBuffer vertices(count);
    transform(mesh.positions, view, 1, 0, count, vertices);
    Assembly all;
    const auto placed = [&](std::uint32_t vertex) { return vertices[vertex].x != needs_clipping; };
    for (std::uint32_t i = 0; i < mesh.triangles.size(); ++i) {
        const glm::uvec3 c = mesh.triangles[i];
        if (placed(c.x) && placed(c.y) && placed(c.z)) {
            all.triangles.push_back(
                {.v = {vertices[c.x], vertices[c.y], vertices[c.z]}, .source = i});
        } else if (!clip_triangle(mesh, i, view, vertices, all.triangles)) {
            ++all.not_finite;
        }
    }
    return all;
}

}  // namespace glint
