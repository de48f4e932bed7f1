// For builds without libseccomp: the students' own machines, where they run their own code.
#include "tests/grading/sandbox/system_calls.hpp"

namespace glint::grading {

bool has_system_call_filter() {
    return false;
}

std::vector<unsigned char> system_call_filter(Calls, pid_t) {
    return {};
}

bool install_filter(const std::vector<unsigned char>&) {
    return true;
}

}  // namespace glint::grading
