// Known mistakes: other lines for the answer of one task. A file has, as often as one likes,
//
//     // MUTANT 09.1 a lobe without its 1/pi
//         return (n + T(2.0F)) * T(0.5F);
//
// The words complete "your values are those of ...". A head with RIGHT instead is another way to
// the right answer, which must not be hurt.
#pragma once

#include "tests/grading/instructor/marks.hpp"

namespace glint::grading {

struct Mutant {
    std::string task, words;
    Lines code;
    bool right;
};

// Lines before the first mutant are an Error.
std::vector<Mutant> read_mutants(const std::string& file, std::string_view text);

}  // namespace glint::grading
