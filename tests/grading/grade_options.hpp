// What grade is asked to do.
#pragma once

#include "tests/grading/class.hpp"

#include <map>

namespace glint::grading {

using Form = std::string (*)(const Report&);

// What a report is written as, by the name of the option.
extern const std::map<std::string, Form> forms;

struct Options {
    std::string command;  // one, class, export, bundle or doctor
    ClassOrder c;         // what one submission is graded by, too
    std::vector<std::string> lessons;
    std::filesystem::path submission = SOURCE_FOLDER, secret, metadata, handout, archive,
                          bundled_secret;                // which is not read
    std::map<std::string, std::filesystem::path> files;  // by form
    std::string part;
    bool slurm = false;
    int chunk = 32;
};

// Says what there is and ends the program where that is asked for; an Error where options are
// wrong.
Options parse_options(int argc, char** argv);

}  // namespace glint::grading
