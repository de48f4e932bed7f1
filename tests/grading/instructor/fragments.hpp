// A small picture's fragments: drawn by the grader, to be shaded by students.
#pragma once

#include "framework/geometry/mesh.hpp"

#include <nlohmann/json_fwd.hpp>

#include <string>
#include <vector>

namespace glint::grading {

// What the rasterizer knows of a pixel; the vectors have unit length.
struct Fragment {
    int pixel;  // counted row by row from the top
    glm::vec3 normal, light, viewer;
    Material material;
    bool is_metal;

    float NL() const { return dot(normal, light); }
    float NV() const { return dot(normal, viewer); }
};

struct Fragments {
    int width, height;
    std::vector<Fragment> all;  // of the pixels where there is something
};

// The still life of the lessons under one light, seen as small as a thumbnail.
const Fragments& still_life_fragments();

// Appends a part of a question: a number as it is, or by name
//     normal 3, light 3, viewer 3, incidence 3 (N.L, N.V, L.V), diffuse 3, specular 3,
//     exponent 1, metal 1 (1 for the teapot), codes 3 (the normal as a colour's codes, 0..1)
// Another name is an Error.
void put_part(const Fragment& f, const nlohmann::json& part, std::vector<double>& row);

}  // namespace glint::grading
