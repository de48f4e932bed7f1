// Reads Wavefront OBJ files and the MTL material files that they name.
#pragma once

#include "framework/geometry/mesh.hpp"

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace glint {

struct Obj {
    Mesh mesh;                            // with normals; with uvs if any face has them
    std::vector<Material> materials;      // those of the MTL files in their order, then defaults
    std::vector<std::string> warnings;    // one line each, file and line number first
    std::size_t dropped_faces = 0;        // had fewer than 3 distinct vertices, are not in the mesh
    std::size_t zero_area_triangles = 0;  // are in the mesh; they cover nothing
};

// Triangles come in the order of the file, polygons as fans round their first vertex; vertices in
// the order in which faces first name them. Faces without usemtl, or with the name of no known
// material, get Material's own values.
//
// Normals are the file's, made unit length. Where it has none, or zero or NaN: the sum of the
// cross products of the triangles at this v (larger ones count for more), whatever their vt.
// Faces without vt get (0, 0) if others have it. Lines, points, curves, groups and smoothing
// groups are passed over. Kd, Ks, Ns, Ni and map_Kd are read; what an MTL leaves out or spells
// wrongly keeps Material's value. map_Kd is relative to the MTL; without a readable file it is
// left empty.
//
// Errors, with the line where there is one: no such file, not a file, more than 2 GiB, not text,
// no triangle, an index of nothing, a number that is none or not finite, a statement cut short.
// Warnings: an MTL or a picture that cannot be read, unknown materials and statements, faces
// that were dropped, normals that had to be made.
Obj read_obj(const std::filesystem::path& path);

// The same for a text in memory; path is what messages call it, its MTL files lie beside that.
Obj parse_obj(std::string_view text, const std::filesystem::path& path);

}  // namespace glint
