// What a test can ask of any mesh: is it valid, closed, which way does it face.
#pragma once

#include "framework/geometry/mesh.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <tuple>
#include <utility>

namespace glint {

// Vertices at equal positions count as one.
struct Topology {
    int vertices = 0;
    int edges = 0;
    int triangles = 0;
    int borders = 0;         // closed chains of edges that have a triangle on one side only
    bool oriented = true;    // no edge is walked twice the same way
    bool collapsed = false;  // a triangle has two corners at one position
    int euler() const { return vertices - edges + triangles; }
    bool closed() const { return borders == 0 && oriented && !collapsed; }
};

inline std::vector<int> welded(const Mesh& mesh) {
    std::map<std::tuple<float, float, float>, int> places;
    std::vector<int> place;
    for (const glm::vec3& p : mesh.positions) {
        const int next = static_cast<int>(places.size());
        place.push_back(places.try_emplace({p.x, p.y, p.z}, next).first->second);
    }
    return place;
}

inline int count_chains(const std::map<int, int>& next) {
    std::set<int> seen;
    int chains = 0;
    for (const auto& [start, unused] : next) {
        chains += seen.contains(start) ? 0 : 1;
        for (int at = start; seen.insert(at).second;) {
            at = next.contains(at) ? next.at(at) : at;
        }
    }
    return chains;
}

inline Topology topology(const Mesh& mesh) {
    const std::vector<int> place = welded(mesh);
    std::set<std::pair<int, int>> walked;
    std::set<int> used;
    Topology result;
    for (const glm::uvec3& t : mesh.triangles) {
        for (int i = 0; i < 3; ++i) {
            const int a = place[t[i]];
            const int b = place[t[(i + 1) % 3]];
            result.collapsed = result.collapsed || a == b;
            result.oriented = walked.insert({a, b}).second && result.oriented;
            used.insert(a);
        }
    }
    std::map<int, int> border;
    for (const auto& [a, b] : walked) {
        const bool open = !walked.contains({b, a});
        result.edges += open || a < b ? 1 : 0;
        if (open) {
            border[a] = b;
        }
    }
    result.borders = count_chains(border);
    result.vertices = static_cast<int>(used.size());
    result.triangles = static_cast<int>(mesh.triangles.size());
    return result;
}

inline glm::dvec3 corner(const Mesh& mesh, const glm::uvec3& t, int i) {
    return {mesh.positions[t[i]]};
}

// Twice the area, along the side from which the corners run counter-clockwise.
inline glm::dvec3 cross_product(const Mesh& mesh, const glm::uvec3& t) {
    return cross(corner(mesh, t, 1) - corner(mesh, t, 0), corner(mesh, t, 2) - corner(mesh, t, 0));
}

// Positive where a closed mesh faces outwards.
inline double volume(const Mesh& mesh) {
    double six = 0.0;
    for (const glm::uvec3& t : mesh.triangles) {
        six += dot(corner(mesh, t, 0), cross_product(mesh, t));
    }
    return six / 6.0;
}

inline bool is_finite(const glm::vec3& v) {
    return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

// Sizes agree, indices are in range, all numbers are finite, normals have length 1.
inline bool is_valid(const Mesh& mesh) {
    const std::size_t n = mesh.positions.size();
    bool good = !mesh.triangles.empty() && (mesh.normals.empty() || mesh.normals.size() == n) &&
                (mesh.uvs.empty() || mesh.uvs.size() == n) &&
                (mesh.materials.empty() || mesh.materials.size() == mesh.triangles.size());
    for (const glm::uvec3& t : mesh.triangles) {
        good = good && std::max({t.x, t.y, t.z}) < n;
    }
    for (const glm::vec3& p : mesh.positions) {
        good = good && is_finite(p);
    }
    for (const glm::vec3& v : mesh.normals) {
        good = good && std::abs(length(glm::dvec3(v)) - 1.0) < 2e-7;
    }
    for (const glm::vec2& uv : mesh.uvs) {
        good = good && std::isfinite(uv.x) && std::isfinite(uv.y);
    }
    return good;
}

inline bool uses_every_vertex(const Mesh& mesh) {
    std::vector<bool> used(mesh.positions.size(), false);
    for (const glm::uvec3& t : mesh.triangles) {
        used[t.x] = used[t.y] = used[t.z] = true;
    }
    return std::find(used.begin(), used.end(), false) == used.end();
}

// The least cosine between a triangle and the normals of its corners.
inline double least_agreement(const Mesh& mesh) {
    double least = 1.0;
    for (const glm::uvec3& t : mesh.triangles) {
        for (int i = 0; i < 3; ++i) {
            const glm::dvec3 facing = normalize(cross_product(mesh, t));
            least = std::min(least, dot(facing, glm::dvec3(mesh.normals[t[i]])));
        }
    }
    return least;
}

// Seen from outside, u to the right and v up give an unmirrored picture: no triangle of the
// texture runs clockwise.
inline bool texture_is_unmirrored(const Mesh& mesh) {
    return std::all_of(mesh.triangles.begin(), mesh.triangles.end(), [&](const glm::uvec3& t) {
        const glm::dvec2 a(mesh.uvs[t.x]);
        const glm::dvec2 b = glm::dvec2(mesh.uvs[t.y]) - a;
        const glm::dvec2 c = glm::dvec2(mesh.uvs[t.z]) - a;
        return b.x * c.y - b.y * c.x > 0.0;
    });
}

inline bool uvs_within(const Mesh& mesh, float low, float high) {
    return std::all_of(mesh.uvs.begin(), mesh.uvs.end(), [&](const glm::vec2& uv) {
        return std::min(uv.x, uv.y) >= low && std::max(uv.x, uv.y) <= high;
    });
}

}  // namespace glint
