#include "tests/grading/instructor/handout.hpp"

#include "framework/image/file.hpp"
#include "framework/math/error.hpp"
#include "tests/grading/cases.hpp"
#include "tests/grading/instructor/marks.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <set>
#include <sstream>

namespace glint::grading {
namespace {

namespace fs = std::filesystem;

std::set<std::string> kept_paths(const fs::path& from) {
    std::set<std::string> paths;
    std::istringstream lines(read_text(from / "tests/grading/instructor/paths.txt"));
    for (std::string line; std::getline(lines, line);) {
        if (!line.starts_with("#")) {
            paths.insert(line);
        }
    }
    return paths;
}

// Build folders are nobody's source.
bool is_built(const std::string& path) {
    return path.starts_with("build") || path == ".cache" || path == "CMakeUserPresets.json" ||
           path == "compile_commands.json";
}

bool has_marks(const fs::path& file) {
    const std::string name = file.filename().string();
    return name.ends_with(".hpp") || name.ends_with(".cpp") || name.ends_with(".cmake") ||
           name == "CMakeLists.txt";
}

// Calls f(path from the root) for each file that students get something of.
template <class F>
void for_each_file(const fs::path& from, F f) {
    const auto kept = kept_paths(from);
    for (auto entry = fs::recursive_directory_iterator(from); entry != fs::end(entry); ++entry) {
        const fs::path path = fs::relative(entry->path(), from);
        if (kept.contains(path.generic_string()) || is_built(path.generic_string())) {
            entry.disable_recursion_pending();
        } else if (entry->is_regular_file()) {
            f(path);
        }
    }
}

void write_file(const fs::path& from, const fs::path& to) {
    fs::create_directories(to.parent_path());
    if (has_marks(from)) {
        const auto regions = read_marks(from.string(), read_text(from));
        write_text(to, handed_out(regions));
        fs::permissions(to, fs::status(from).permissions());
    } else {
        fs::copy_file(from, to);
    }
}

void write_cases(const fs::path& to) {
    fs::create_directories(to);
    for (const std::string& name : graded_lessons()) {
        const nlohmann::json cases = cases_of(name, std::nullopt);
        write_text(to / (name + ".json"), cases.dump() + '\n');
    }
}

std::string trimmed(const std::string& line) {
    const std::size_t begin = line.find_first_not_of(' ');
    return begin == std::string::npos ? ""
                                      : line.substr(begin, line.find_last_not_of(' ') + 1 - begin);
}

// Long, and no line that any function might have.
bool says_enough(const std::string& line) {
    return line.size() >= 24 && !line.starts_with("//") && !line.starts_with("for (") &&
           !line.starts_with("const auto square = [](");
}

}  // namespace

void hand_out(const fs::path& from, const fs::path& to) {
    if (fs::exists(to) && !(fs::is_directory(to) && fs::is_empty(to))) {
        throw Error(to.string() + ": is there already; name a folder that is not, or empty");
    }
    fs::path beside = fs::absolute(to).lexically_normal();
    beside = beside.parent_path() / (beside.filename().string() + ".new");
    fs::remove_all(beside);
    try {
        for_each_file(from, [&](const fs::path& path) { write_file(from / path, beside / path); });
        write_cases(beside / "tests/grading/cases");
        fs::remove(to);
        fs::rename(beside, to);
    } catch (...) {
        fs::remove_all(beside);
        throw;
    }
}

std::vector<std::string> telling_lines(const fs::path& from) {
    std::set<std::string> lines;
    for_each_file(from / "", [&](const fs::path& path) {
        if (has_marks(path)) {
            for (const Region& r : read_marks(path.string(), read_text(from / path))) {
                for (const std::string& line : r.task.empty() ? Lines{} : r.solution) {
                    const std::string text = trimmed(line);
                    if (says_enough(text)) {
                        lines.insert(text);
                    }
                }
            }
        }
    });
    return {lines.begin(), lines.end()};
}

}  // namespace glint::grading
