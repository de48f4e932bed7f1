#include "tests/grading/instructor/links.hpp"

#include <regex>
#include <sstream>

namespace glint::grading {
namespace {

namespace fs = std::filesystem;

std::string line_without_dead_links(std::string line, const fs::path& folder, const Paths& there) {
    static const std::regex link(R"((^|[^!])\[([^\]]+)\]\(([\w./-]+)(#[\w-]*)?\))");
    std::string out;
    for (std::smatch match; std::regex_search(line, match, link);) {
        const std::string path = (folder / match.str(3)).lexically_normal().generic_string();
        const bool is_there = there.contains(path.substr(0, path.find_last_not_of('/') + 1));
        out += match.prefix().str() + (is_there ? match.str() : match.str(1) + match.str(2));
        line = match.suffix();
    }
    return out + line;
}

}  // namespace

Paths with_folders(const std::vector<fs::path>& files) {
    Paths all;
    for (fs::path path : files) {
        for (; !path.empty(); path = path.parent_path()) {
            all.insert(path.generic_string());
        }
    }
    return all;
}

std::string without_dead_links(const std::string& text, const fs::path& file, const Paths& there) {
    std::istringstream lines(text);
    std::string out;
    bool in_code = false;
    for (std::string line; std::getline(lines, line); out += '\n') {
        const bool fence = line.starts_with("```");
        in_code = in_code != fence;
        out += in_code || fence ? line : line_without_dead_links(line, file.parent_path(), there);
    }
    return out;
}

}  // namespace glint::grading
