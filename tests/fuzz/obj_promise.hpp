// What the OBJ reader promises for any bytes: a valid mesh or an Error of one line.
#pragma once

#include "framework/geometry/mtl.hpp"
#include "framework/geometry/obj.hpp"
#include "framework/math/error.hpp"
#include "tests/unit/geometry/mesh_checks.hpp"

#include <cstdint>
#include <cstdlib>
#include <iostream>

namespace glint {

inline void demand(bool condition, const char* what) {
    if (!condition) {
        std::cerr << "the reader broke its promise: " << what << '\n';
        std::abort();
    }
}

inline void demand_line(std::string_view text) {
    demand(!text.empty() && text.size() < 1000, "a message is of readable length");
    demand(std::none_of(text.begin(), text.end(),
                        [](char c) { return static_cast<unsigned char>(c) < 0x20; }),
           "a message is one line without control characters");
}

inline void demand_material(const Material& m) {
    for (int i = 0; i < 3; ++i) {
        demand(m.diffuse[i] >= 0.0F && m.diffuse[i] <= 1.0F, "diffuse is 0..1");
        demand(m.specular[i] >= 0.0F && m.specular[i] <= 1.0F, "specular is 0..1");
    }
    demand(m.exponent >= 0.0F && std::isfinite(m.exponent), "the exponent is 0 or more");
    demand(m.ior > 0.0F && std::isfinite(m.ior), "the refractive index is positive");
}

inline void demand_obj(const Obj& obj) {
    demand(is_valid(obj.mesh), "the mesh is valid");
    demand(!obj.mesh.normals.empty(), "the mesh has normals");
    demand(uses_every_vertex(obj.mesh), "every vertex belongs to a triangle");
    demand(obj.mesh.materials.size() == obj.mesh.triangles.size(), "triangles have materials");
    for (const std::uint16_t m : obj.mesh.materials) {
        demand(m < obj.materials.size(), "materials are in range");
    }
    for (const Material& m : obj.materials) {
        demand_material(m);
    }
    for (const std::string& line : obj.warnings) {
        demand_line(line);
    }
}

// Reads the text as an OBJ and as an MTL and ends the program if either breaks the promise. True
// if the OBJ was read, false if it was refused.
inline bool keeps_promise(std::string_view text) {
    Warnings warnings;
    for (const Material& m : parse_mtl(text, "tests/data/obj/input.mtl", warnings)) {
        demand_material(m);
    }
    for (const std::string& line : warnings.take()) {
        demand_line(line);
    }
    try {
        demand_obj(parse_obj(text, "tests/data/obj/input.obj"));
    } catch (const Error& e) {
        demand_line(e.what());
        return false;
    }
    return true;
}

}  // namespace glint
