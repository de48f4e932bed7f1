#include "framework/geometry/obj_builder.hpp"

#include "framework/geometry/mtl.hpp"
#include "framework/geometry/obj_text.hpp"
#include "framework/math/error.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace glint {
namespace {

constexpr auto empty_slot = std::numeric_limits<std::uint32_t>::max();

std::uint64_t hash(const Corner& c) {
    const auto bits = [](std::int32_t i) { return static_cast<std::uint64_t>(i); };
    std::uint64_t h = bits(c.position) * 0x9E3779B97F4A7C15U + bits(c.uv) * 0xC2B2AE3D27D4EB4FU +
                      bits(c.normal) * 0x165667B19E3779F9U;
    h = (h ^ (h >> 32U)) * 0xD6E8FEB86659FD93U;
    return h ^ (h >> 32U);
}

bool is_finite(const glm::vec3& v) {
    return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

bool spans_a_triangle(std::span<const Corner> face) {
    const auto differs = [](std::int32_t p) {
        return [p](const Corner& c) { return c.position != p; };
    };
    const auto second = std::find_if(face.begin(), face.end(), differs(face[0].position));
    return second != face.end() && std::any_of(second, face.end(), [&](const Corner& c) {
               return c.position != face[0].position && c.position != second->position;
           });
}

}  // namespace

std::size_t CornerNumbers::slot_of(const Corner& corner) const {
    const std::size_t mask = slots_.size() - 1;  // the size is a power of two
    std::size_t slot = hash(corner) & mask;
    while (slots_[slot] != empty_slot && corners_[slots_[slot]] != corner) {
        slot = (slot + 1) & mask;
    }
    return slot;
}

void CornerNumbers::grow() {
    slots_.assign(std::max<std::size_t>(64, 2 * slots_.size()), empty_slot);
    for (std::uint32_t i = 0; i < corners_.size(); ++i) {
        slots_[slot_of(corners_[i])] = i;
    }
}

std::uint32_t CornerNumbers::operator()(const Corner& corner) {
    if (2 * corners_.size() >= slots_.size()) {
        grow();
    }
    std::uint32_t& number = slots_[slot_of(corner)];
    if (number == empty_slot) {
        number = static_cast<std::uint32_t>(corners_.size());
        corners_.push_back(corner);
    }
    return number;
}

void ObjBuilder::fail(const std::string& what) const {
    throw Error(at_line(path_, line_) + what);
}

void ObjBuilder::warn(const std::string& what) {
    warnings_.add(at_line(path_, line_) + what);
}

void ObjBuilder::add_position(const glm::vec3& p) {
    if (!is_finite(p)) {
        fail("a coordinate is too large");
    }
    positions_.push_back(p);
}

void ObjBuilder::add_uv(const glm::vec2& uv) {
    if (!std::isfinite(uv.x) || !std::isfinite(uv.y)) {
        fail("a texture coordinate is too large");
    }
    uvs_.push_back(uv);
}

void ObjBuilder::add_normal(const glm::vec3& n) {
    const glm::dvec3 exact(n);
    const bool usable = is_finite(n) && n != glm::vec3(0.0F);
    if (!usable) {
        zero_normals_.add(line_);
    }
    normals_.push_back(usable ? glm::vec3(normalize(exact)) : glm::vec3(0.0F));
}

std::int32_t ObjBuilder::resolve(std::int32_t index, std::size_t count, const char* what) const {
    const auto size = static_cast<std::int32_t>(count);
    const std::int32_t from_zero = index > 0 ? index - 1 : size + index;
    if (from_zero < 0 || from_zero >= size) {
        const std::string kind(what);
        fail(kind + " index " + std::to_string(index) + " is out of range (the file has " +
             std::to_string(count) + (kind == "vertex" ? " vertices" : " of them") +
             " up to here)");
    }
    return from_zero;
}

Corner ObjBuilder::resolved(const Corner& c) const {
    Corner r{.position = resolve(c.position, positions_.size(), "vertex")};
    if (c.uv != 0) {
        r.uv = resolve(c.uv, uvs_.size(), "texture coordinate");
    }
    if (c.normal != 0) {
        r.normal = resolve(c.normal, normals_.size(), "normal");
        if (normals_[static_cast<std::size_t>(r.normal)] == glm::vec3(0.0F)) {
            r.normal = -1;
        }
    }
    return r;
}

void ObjBuilder::add_face(std::span<const Corner> face) {
    std::vector<Corner> corners;
    for (const Corner& c : face) {
        corners.push_back(resolved(c));
    }
    if (!spans_a_triangle(corners)) {
        dropped_.add(line_);
        return;
    }
    fan_.clear();
    for (const Corner& c : corners) {
        fan_.push_back(number_(c));
    }
    if (!material_) {
        material_ = add_material({});
    }
    for (std::size_t i = 2; i < fan_.size(); ++i) {
        obj_.mesh.triangles.emplace_back(fan_[0], fan_[i - 1], fan_[i]);
        obj_.mesh.materials.push_back(*material_);
    }
}

std::uint16_t ObjBuilder::add_material(Material material) {
    if (obj_.materials.size() == max_materials) {
        fail("more than 65536 materials");
    }
    const auto number = static_cast<std::uint16_t>(obj_.materials.size());
    material_numbers_.try_emplace(material.name, number);  // of two with one name, the first
    obj_.materials.push_back(std::move(material));
    return number;
}

void ObjBuilder::add_materials(std::vector<Material> materials) {
    for (Material& m : materials) {
        add_material(std::move(m));
    }
}

void ObjBuilder::use_material(std::string_view name) {
    const auto known = material_numbers_.find(name);
    if (known != material_numbers_.end()) {
        material_ = known->second;
        return;
    }
    warn("no MTL file defines material " + shown(name));
    Material unknown;
    unknown.name = name;
    material_ = add_material(std::move(unknown));
}

void ObjBuilder::make_vertices() {
    Mesh& mesh = obj_.mesh;
    const std::vector<Corner>& corners = number_.corners();
    const bool has_uvs =
        std::any_of(corners.begin(), corners.end(), [](const Corner& c) { return c.uv >= 0; });
    for (const Corner& c : corners) {
        mesh.positions.push_back(positions_[static_cast<std::size_t>(c.position)]);
        if (has_uvs) {
            mesh.uvs.push_back(c.uv < 0 ? glm::vec2(0.0F) : uvs_[static_cast<std::size_t>(c.uv)]);
        }
    }
}

std::vector<glm::dvec3> ObjBuilder::sums_of_cross_products() {
    const Mesh& mesh = obj_.mesh;
    const std::vector<Corner>& corners = number_.corners();
    std::vector<glm::dvec3> sums(positions_.size(), glm::dvec3(0.0));
    for (const glm::uvec3& t : mesh.triangles) {
        const glm::dvec3 a(mesh.positions[t.x]);
        const glm::dvec3 product =
            cross(glm::dvec3(mesh.positions[t.y]) - a, glm::dvec3(mesh.positions[t.z]) - a);
        obj_.zero_area_triangles += product == glm::dvec3(0.0) ? 1 : 0;
        for (int i = 0; i < 3; ++i) {
            sums[static_cast<std::size_t>(corners[t[i]].position)] += product;
        }
    }
    return sums;
}

void ObjBuilder::make_normals() {
    const std::vector<glm::dvec3> sums = sums_of_cross_products();
    for (const Corner& c : number_.corners()) {
        if (c.normal >= 0) {
            obj_.mesh.normals.push_back(normals_[static_cast<std::size_t>(c.normal)]);
            continue;
        }
        const glm::dvec3 sum = sums[static_cast<std::size_t>(c.position)];
        const bool has_direction = dot(sum, sum) > 0.0;
        directionless_ += has_direction ? 0 : 1;
        obj_.mesh.normals.emplace_back(has_direction ? normalize(sum) : glm::dvec3(0, 0, 1));
    }
}

void ObjBuilder::report(const Tally& tally, const std::string& what) {
    if (tally.count != 0) {
        const std::string more = " (and " + std::to_string(tally.count - 1) + " more)";
        warnings_.add(at_line(path_, tally.first_line) + what + (tally.count > 1 ? more : ""));
    }
}

void ObjBuilder::report() {
    report(dropped_, "the face has fewer than 3 distinct vertices: dropped");
    report(zero_normals_, "the normal is zero or not finite: made from the faces");
    const std::string name = in_file(path_);
    if (obj_.zero_area_triangles != 0) {
        warnings_.add(name + std::to_string(obj_.zero_area_triangles) +
                      " triangles have no area: they stay, but cover nothing");
    }
    if (directionless_ != 0) {
        warnings_.add(name + std::to_string(directionless_) +
                      " vertices have faces without a common side: their normal is (0, 0, 1)");
    }
}

Obj ObjBuilder::finish() {
    if (obj_.mesh.triangles.empty()) {
        throw Error(in_file(path_) + "has no faces" +
                    (dropped_.count != 0 ? " with 3 distinct vertices" : ""));
    }
    make_vertices();
    make_normals();
    report();
    obj_.dropped_faces = dropped_.count;
    obj_.warnings = warnings_.take();
    return std::move(obj_);
}

}  // namespace glint
