#include "tests/grading/students.hpp"

#include "framework/image/file.hpp"
#include "framework/math/error.hpp"
#include "tests/grading/archive.hpp"
#include "tests/grading/plain_text.hpp"

#include <map>
#include <sstream>
#include <strings.h>

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

// Of a line of CSV. In quotes, "" is a quote.
std::string first_field(const std::string& line, char separator, const std::string& where) {
    if (!line.starts_with('"')) {
        return line.substr(0, line.find(separator));
    }
    std::string field;
    for (std::size_t i = 1; i < line.size(); ++i) {
        if (line[i] == '"' && line[++i] != '"') {
            return field;
        }
        field += line[i];
    }
    throw Error(where + ": a quote without its end; write \"student\",...");
}

bool is_heading(const std::string& field) {
    return strcasecmp(field.c_str(), "student") == 0;
}

// Spreadsheets write marks of the byte order and of the line's end, and where a comma is that of
// numbers, semicolons.
void add_roster(Submissions& all, const fs::path& roster) {
    std::string text = read_text(roster);
    if (!is_plain_text(text)) {
        throw Error(roster.string() + ": is not in UTF-8; save it as CSV in UTF-8");
    }
    if (text.starts_with("\xef\xbb\xbf")) {
        text.erase(0, 3);
    }
    const std::string first_line = text.substr(0, text.find('\n'));
    const bool commas = first_line.find(',') != std::string::npos;
    const char separator = commas || first_line.find(';') == std::string::npos ? ',' : ';';
    std::istringstream lines(text);
    int number = 0;
    for (std::string line; std::getline(lines, line);) {
        const std::string where = roster.string() + ':' + std::to_string(++number);
        line.erase(line.find_last_not_of('\r') + 1);
        const std::string name = first_field(line, separator, where);
        if (!name.empty() && !(number == 1 && is_heading(name))) {
            require_name(name, where);
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
