#include "tests/grading/students.hpp"

#include "framework/image/file.hpp"
#include "framework/math/error.hpp"
#include "tests/grading/archive.hpp"
#include "tests/grading/plain_text.hpp"

#include <map>
#include <sstream>

namespace glint::grading {
namespace {

namespace fs = std::filesystem;

using Submissions = std::map<std::string, fs::path>;

// Reports go to a folder of the student's name, beside the class's own files.
void require_name(const std::string& name, const std::string& where) {
    static const std::set<std::string> others{"",     ".", "..", "grades.csv", "statistics.csv",
                                              "slurm"};
    if (others.contains(name) || name.find('/') != std::string::npos) {
        throw Error(where + ": no student can be called '" + printable(name, 80) +
                    "', for the reports lie in a folder of that name; write another name");
    }
}

void add_roster(Submissions& all, const fs::path& roster) {
    std::istringstream lines(read_text(roster));
    for (std::string line; std::getline(lines, line);) {
        const std::string name = line.substr(0, line.find_first_of(",\r"));
        if (!name.empty() && name != "student") {  // a heading
            require_name(name, roster.string());
            all[name];
        }
    }
}

void add_submission(Submissions& all, const std::string& name, const fs::path& path) {
    require_name(name, path.string());
    fs::path& submission = all[name];
    if (!submission.empty()) {
        throw Error(submission.string() + " and " + path.string() +
                    ": two submissions of one student; keep the one that counts");
    }
    submission = path;
}

bool is_folder(const fs::directory_entry& entry) {
    return entry.symlink_status().type() == fs::file_type::directory;
}

bool is_zip(const fs::directory_entry& entry) {
    return entry.symlink_status().type() == fs::file_type::regular && is_archive(entry.path());
}

}  // namespace

std::vector<Student> students_of(const fs::path& folder, const fs::path& roster) {
    Submissions all;
    if (!roster.empty()) {
        add_roster(all, roster);
    }
    for (const auto& entry : fs::directory_iterator(folder)) {
        const fs::path& path = entry.path();
        if (is_folder(entry)) {
            add_submission(all, path.filename(), path);
        } else if (is_zip(entry)) {
            add_submission(all, path.stem(), path);
        }
    }
    std::vector<Student> students;
    students.reserve(all.size());
    for (const auto& [name, path] : all) {
        students.push_back({name, path});
    }
    return students;
}

std::set<fs::path> not_taken(const fs::path& folder) {
    std::set<fs::path> others;
    for (const auto& entry : fs::directory_iterator(folder)) {
        if (!is_folder(entry) && !is_zip(entry)) {
            others.insert(entry.path());
        }
    }
    return others;
}

void require_outside(const fs::path& folder, const fs::path& out) {
    const fs::path way =
        fs::weakly_canonical(fs::absolute(out)).lexically_relative(fs::canonical(folder));
    if (*way.begin() != "..") {
        throw Error("--out " + out.string() + ": lies in " + folder.string() +
                    ", where it would be taken for a student; name a folder elsewhere");
    }
}

}  // namespace glint::grading
