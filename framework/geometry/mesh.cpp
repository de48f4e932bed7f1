#include "framework/geometry/mesh.hpp"

#include "framework/math/error.hpp"

#include <glm/common.hpp>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>
#include <glm/vector_relational.hpp>

#include <algorithm>
#include <utility>

namespace glint {
namespace {

void check_affine(const glm::mat4& m) {
    if (m[0][3] != 0.0F || m[1][3] != 0.0F || m[2][3] != 0.0F || m[3][3] != 1.0F) {
        throw Error("transform: the last row of the matrix must be 0 0 0 1");
    }
}

// The inverse transpose up to a factor: it has no division, so small scales lose nothing.
glm::dmat3 cofactors(const glm::dmat3& m) {
    return {cross(m[1], m[2]), cross(m[2], m[0]), cross(m[0], m[1])};
}

std::size_t vertices_after(const Mesh& mesh, const Mesh& other) {
    const std::size_t count = mesh.positions.size() + other.positions.size();
    if (count > std::numeric_limits<std::uint32_t>::max()) {
        throw Error("append: a mesh can have at most 2^32 - 1 vertices");
    }
    return count;
}

// Also right if both are the same.
template <class T>
void concatenate(LineVector<T>& to, const LineVector<T>& from) {
    const std::size_t before = to.size();
    const std::size_t count = from.size();
    to.resize(before + count);
    std::copy_n(from.begin(), count, to.begin() + static_cast<std::ptrdiff_t>(before));
}

}  // namespace

Mesh transform(Mesh mesh, const glm::mat4& matrix) {
    check_affine(matrix);
    const glm::dmat4 m(matrix);
    const glm::dmat3 linear(m);
    const double determinant = glm::determinant(linear);
    if (!std::isnormal(determinant)) {
        throw Error("transform: the matrix must be finite and invertible");
    }
    const glm::dmat3 to_normals = cofactors(linear) * (determinant > 0.0 ? 1.0 : -1.0);
    for (glm::vec3& p : mesh.positions) {
        p = glm::vec3(m * glm::dvec4(p, 1.0));
    }
    for (glm::vec3& n : mesh.normals) {
        n = glm::vec3(normalize(to_normals * glm::dvec3(n)));
    }
    if (determinant < 0.0) {
        for (glm::uvec3& t : mesh.triangles) {
            std::swap(t.y, t.z);
        }
    }
    return mesh;
}

void append(Mesh& mesh, const Mesh& other, std::uint16_t material) {
    const std::size_t before = mesh.positions.size();
    const std::size_t after = vertices_after(mesh, other);
    if (before != 0 && !other.positions.empty() && mesh.normals.empty() != other.normals.empty()) {
        throw Error("append: either both meshes have normals or neither");
    }
    if (!mesh.materials.empty() || material != 0) {
        mesh.materials.resize(mesh.triangles.size(), 0);
        mesh.materials.resize(mesh.triangles.size() + other.triangles.size(), material);
    }
    const std::size_t triangles_before = mesh.triangles.size();
    concatenate(mesh.triangles, other.triangles);
    for (std::size_t i = triangles_before; i < mesh.triangles.size(); ++i) {
        mesh.triangles[i] += static_cast<std::uint32_t>(before);
    }
    if (!mesh.uvs.empty() || !other.uvs.empty()) {
        mesh.uvs.resize(before);
        concatenate(mesh.uvs, other.uvs);
        mesh.uvs.resize(after);
    }
    concatenate(mesh.positions, other.positions);
    concatenate(mesh.normals, other.normals);
}

Bounds bounds(const Mesh& mesh) {
    if (mesh.positions.empty()) {
        throw Error("bounds: the mesh has no vertices");
    }
    Bounds box{mesh.positions[0], mesh.positions[0]};
    for (const glm::vec3& p : mesh.positions) {
        box.low = glm::min(box.low, p);
        box.high = glm::max(box.high, p);
    }
    return box;
}

}  // namespace glint
