// Runs a program that is not trusted.
#pragma once

#include "tests/grading/sandbox/landlock.hpp"
#include "tests/grading/sandbox/system_calls.hpp"

#include <chrono>
#include <optional>
#include <string>

namespace glint::grading {

inline constexpr std::size_t KB = 1024;
inline constexpr std::size_t MB = 1024 * KB;

struct Limits {
    std::chrono::milliseconds processor, wall;
    std::size_t memory, stack, file_size;  // bytes; of each process
    std::size_t output, diagnostics;       // bytes; whoever writes more is ended
};

struct Confinement {
    Calls calls;
    Limits limits;
    std::optional<Reach> reach;         // none: nothing is said about files
    std::optional<uid_t> user;          // to be instead of root; a user with nothing else to do
    std::filesystem::path folder{"/"};  // where it works
};

struct Program {
    std::filesystem::path file;
    std::vector<std::string> arguments, environment;  // the arguments after the name
    std::string input;                                // what it reads from file descriptor 3
};

struct Ended {
    enum class How {
        exited,
        signalled,
        out_of_time,   // by the wall clock
        output_limit,  // more than the limits' output or diagnostics
        not_started,   // more memory than the limit before the first instruction
    };
    How how;
    int code;                         // exit code or signal
    std::string output, diagnostics;  // of file descriptor 4; of 1 and 2
    double seconds;                   // of processor time
};

// Waits until the program and all of its group are gone. It finds its input at file descriptor 3,
// writes its output to 4, and no other descriptor is open but 0, 1 and 2. What goes wrong before
// its first instruction, and is not its fault, is thrown as std::runtime_error.
Ended run_confined(const Program& program, const Confinement& confinement);

// The user to be where this process is root: nobody's, and another one for each process.
std::optional<uid_t> nobodys_user();

}  // namespace glint::grading
