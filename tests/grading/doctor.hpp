// Which protections this machine has, found out by trying, and whether it reads archives.
#pragma once

#include <string>
#include <vector>

namespace glint::grading {

struct Protection {
    std::string name, state;
    bool there;
    bool needed;  // for hidden cases
};

std::vector<Protection> protections();

// True where hidden cases may be run.
bool is_protected(const std::vector<Protection>& all);

}  // namespace glint::grading
