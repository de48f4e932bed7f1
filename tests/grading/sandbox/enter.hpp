// The way into a confinement, walked by the child between fork and exec.
#pragma once

#include "tests/grading/sandbox/confine.hpp"

namespace glint::grading {

// Ends of pipes for the child: 0..5 in the end, and where it says what went wrong.
struct ChildEnds {
    int null, diagnostics, input, output, program, trouble;
};

// Never returns: executes the program, or writes to trouble the name of the step that failed.
[[noreturn]] void enter(const Program& program, const Confinement& confinement,
                        const ChildEnds& ends, pid_t parent);

// What trouble says where the program itself is too large.
inline constexpr const char* no_room = "no room";

}  // namespace glint::grading
