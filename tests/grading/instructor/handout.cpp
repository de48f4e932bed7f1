#include "tests/grading/instructor/handout.hpp"

#include "framework/image/file.hpp"
#include "framework/math/error.hpp"
#include "tests/grading/cases.hpp"
#include "tests/grading/instructor/links.hpp"
#include "tests/grading/instructor/marks.hpp"
#include "tests/temporary.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
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

// The files that git knows of. A tree in use also holds backups of answers, secrets and grades.
std::vector<fs::path> tracked_files(const fs::path& from) {
    const std::string command =
        "git -c safe.directory='*' -C \"$GLINT_SOURCE\" ls-files -z 2>/dev/null";
    ::setenv("GLINT_SOURCE", from.c_str(), 1);
    std::string names;
    FILE* pipe = ::popen(command.c_str(), "r");
    for (int c = 0; pipe != nullptr && (c = std::fgetc(pipe)) != EOF;) {
        names += static_cast<char>(c);
    }
    if (pipe == nullptr || ::pclose(pipe) != 0 || names.empty()) {
        throw Error(from.string() +
                    ": git does not say what belongs to it; hand out from a clone, with git there");
    }
    std::vector<fs::path> files;
    std::istringstream all(names);
    for (std::string name; std::getline(all, name, '\0');) {
        files.emplace_back(name);
    }
    return files;
}

// The path, or a folder that it lies in.
bool is_within(const std::set<std::string>& all, fs::path path) {
    for (; !path.empty(); path = path.parent_path()) {
        if (all.contains(path.generic_string())) {
            return true;
        }
    }
    return false;
}

bool has_marks(const fs::path& file) {
    const std::string name = file.filename().string();
    return name.ends_with(".hpp") || name.ends_with(".cpp") || name.ends_with(".cmake") ||
           name == "CMakeLists.txt";
}

// What students get something of: paths from the root.
std::vector<fs::path> files_for_students(const fs::path& from) {
    const auto kept = kept_paths(from);
    std::vector<fs::path> files = tracked_files(from);
    std::erase_if(files, [&](const fs::path& path) {
        return is_within(kept, path) || !fs::is_regular_file(from / path);
    });
    return files;
}

void write_file(const fs::path& from, const fs::path& path, const Paths& there,
                const fs::path& to) {
    fs::create_directories((to / path).parent_path());
    if (has_marks(path)) {
        const auto regions = read_marks((from / path).string(), read_text(from / path));
        write_text(to / path, handed_out(regions));
        fs::permissions(to / path, fs::status(from / path).permissions());
    } else if (path.extension() == ".md") {
        write_text(to / path, without_dead_links(read_text(from / path), path, there));
    } else {
        fs::copy_file(from / path, to / path);
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
    const std::vector<fs::path> files = files_for_students(from);
    const Paths there = with_folders(files);
    const fs::path target = fs::absolute(to / "").lexically_normal().parent_path();
    fs::create_directories(target.parent_path());
    const TemporaryFolder beside(target.parent_path());  // it takes its name when it is complete
    const fs::path tree = beside / "tree";
    for (const fs::path& path : files) {
        write_file(from, path, there, tree);
    }
    write_cases(tree / "tests/grading/cases");
    fs::remove(to);
    fs::rename(tree, target);
}

std::vector<std::string> telling_lines(const fs::path& from) {
    std::set<std::string> lines;
    for (const fs::path& path : files_for_students(from)) {
        if (!has_marks(path)) {
            continue;
        }
        for (const Region& r : read_marks(path.string(), read_text(from / path))) {
            for (const std::string& line : r.task.empty() ? Lines{} : r.solution) {
                const std::string text = trimmed(line);
                if (says_enough(text)) {
                    lines.insert(text);
                }
            }
        }
    }
    return {lines.begin(), lines.end()};
}

}  // namespace glint::grading
