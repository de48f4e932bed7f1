// Reads MTL material files for the OBJ reader, which says what is read of them.
#pragma once

#include "framework/geometry/mesh.hpp"
#include "framework/geometry/warnings.hpp"

#include <filesystem>
#include <string_view>
#include <vector>

namespace glint {

inline constexpr std::size_t max_materials = 65536;  // Mesh counts them in 16 bits

// An Error only if there are more than max_materials. path is what messages call the text, and
// maps lie relative to it.
std::vector<Material> parse_mtl(std::string_view text, const std::filesystem::path& path,
                                Warnings& warnings);

}  // namespace glint
