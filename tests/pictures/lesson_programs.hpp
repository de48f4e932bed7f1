// The programs that lessons/CMakeLists.txt names.
#pragma once

#include "tests/unit/app/program.hpp"

#include <sstream>
#include <string>
#include <vector>

namespace glint {

inline std::vector<std::string> lesson_names() {
    std::vector<std::string> names;
    std::istringstream words(LESSONS);
    for (std::string name; words >> name;) {
        names.push_back(name);
    }
    return names;
}

inline std::string lesson_program(const std::string& name) {
    return PROGRAM_FOLDER "/" + name;
}

}  // namespace glint
