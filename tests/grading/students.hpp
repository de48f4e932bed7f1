// Who is in a class: by what lies in its folder, and by its roster.
#pragma once

#include <filesystem>
#include <set>
#include <string>
#include <vector>

namespace glint::grading {

struct Student {
    std::string name;
    std::filesystem::path submission;  // empty: nothing was handed in
};

// In the folder, or on the roster where there is one; by name. The roster is a CSV with commas or
// semicolons, in UTF-8, whose first column names the students, under the heading student or none.
// An Error where a name cannot be that of a folder for reports, or where a student has two
// submissions.
std::vector<Student> students_of(const std::filesystem::path& folder,
                                 const std::filesystem::path& roster);

// What else lies in the folder: no folder and no zip archive.
std::set<std::filesystem::path> not_taken(const std::filesystem::path& folder);

// An Error where what is written would be taken for a submission.
void require_outside(const std::filesystem::path& folder, const std::filesystem::path& out);

}  // namespace glint::grading
