// Makes a mesh from what an OBJ file lists one by one. For the reader alone.
#pragma once

#include "framework/geometry/obj.hpp"
#include "framework/geometry/warnings.hpp"

#include <cstdint>
#include <map>
#include <optional>
#include <span>

namespace glint {

// What a face names. In the file: from 1, or back from -1, 0 for none; in the builder: from 0,
// -1 for none.
struct Corner {
    std::int32_t position = -1;
    std::int32_t uv = -1;
    std::int32_t normal = -1;
    friend bool operator==(const Corner&, const Corner&) = default;
};

// Gives each different corner a number, in the order in which they come.
class CornerNumbers {
  public:
    std::uint32_t operator()(const Corner& corner);
    const std::vector<Corner>& corners() const { return corners_; }

  private:
    void grow();
    std::size_t slot_of(const Corner& corner) const;

    std::vector<Corner> corners_;
    std::vector<std::uint32_t> slots_;  // a hash table of their numbers, at most half full
};

class ObjBuilder {
  public:
    explicit ObjBuilder(std::filesystem::path path) : path_(std::move(path)) {}

    void at(std::size_t line) { line_ = line; }  // where the next calls come from
    void add_position(const glm::vec3& p);
    void add_uv(const glm::vec2& uv);
    void add_normal(const glm::vec3& n);  // zero: none
    void add_face(std::span<const Corner> face);
    void add_materials(std::vector<Material> materials);
    void use_material(std::string_view name);

    [[noreturn]] void fail(const std::string& what) const;  // an Error at this line
    void warn(const std::string& what);
    Warnings& warnings() { return warnings_; }

    Obj finish();

  private:
    std::uint16_t add_material(Material material);
    Corner resolved(const Corner& corner) const;
    std::int32_t resolve(std::int32_t index, std::size_t count, const char* what) const;
    std::vector<glm::dvec3> sums_of_cross_products();
    void make_vertices();
    void make_normals();
    void report();
    void report(const Tally& tally, const std::string& what);

    std::filesystem::path path_;
    std::size_t line_ = 0;
    Warnings warnings_;
    std::vector<glm::vec3> positions_;
    std::vector<glm::vec2> uvs_;
    std::vector<glm::vec3> normals_;
    std::map<std::string, std::uint16_t, std::less<>> material_numbers_;
    std::optional<std::uint16_t> material_;
    CornerNumbers number_;
    std::vector<std::uint32_t> fan_;
    Tally dropped_, zero_normals_;
    std::size_t directionless_ = 0;
    Obj obj_;
};

}  // namespace glint
