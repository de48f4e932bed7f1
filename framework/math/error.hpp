// What a user can mend: a bad file, a bad option.
#pragma once

#include <stdexcept>

namespace glint {

// The message is one line: what is wrong, where, and what is allowed.
struct Error : std::runtime_error {
    using std::runtime_error::runtime_error;
};

}  // namespace glint
