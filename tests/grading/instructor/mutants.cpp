#include "tests/grading/instructor/mutants.hpp"

#include "framework/math/error.hpp"

#include <regex>
#include <sstream>

namespace glint::grading {

std::vector<Mutant> read_mutants(const std::string& file, std::string_view text) {
    static const std::regex head(R"(// (MUTANT|RIGHT) (\d\d\.\d) (.+))");
    std::vector<Mutant> all;
    std::istringstream lines{std::string(text)};
    for (std::string line; std::getline(lines, line);) {
        std::smatch match;
        if (std::regex_match(line, match, head)) {
            all.push_back({match[2], match[3], {}, match[1] == "RIGHT"});
        } else if (all.empty()) {
            throw Error(file + ":1: a file of mutants starts with // MUTANT TASK WORDS");
        } else {
            all.back().code.push_back(line);
        }
    }
    return all;
}

}  // namespace glint::grading
