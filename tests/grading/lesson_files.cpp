#include "tests/grading/cases.hpp"

#include <algorithm>

namespace glint::grading {

// CASES_FOLDER has a file for each lesson: manifests with the instructor, cases with students.
std::filesystem::path lesson_file(const std::string& lesson) {
    return std::filesystem::path(CASES_FOLDER) / (lesson + ".json");
}

std::vector<std::string> graded_lessons() {
    std::vector<std::string> names;
    for (const auto& entry : std::filesystem::directory_iterator(CASES_FOLDER)) {
        names.push_back(entry.path().stem());
    }
    std::sort(names.begin(), names.end());
    return names;
}

}  // namespace glint::grading
