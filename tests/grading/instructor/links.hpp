// Links of Markdown texts to files of a tree.
#pragma once

#include <filesystem>
#include <set>
#include <string>
#include <vector>

namespace glint::grading {

using Paths = std::set<std::string>;  // from the root of a tree, with / between

// The files and all folders that they lie in.
Paths with_folders(const std::vector<std::filesystem::path>& files);

// The text of a file of the tree: a link to what is not there becomes its words. Links to the web
// stay, and so do pictures and what stands in code.
std::string without_dead_links(const std::string& text, const std::filesystem::path& file,
                               const Paths& there);

}  // namespace glint::grading
