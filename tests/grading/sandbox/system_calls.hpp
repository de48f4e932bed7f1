// Which system calls a confined process may make: seccomp filters, made with libseccomp.
#pragma once

#include <sys/types.h>
#include <vector>

struct sock_filter;

namespace glint::grading {

enum class Calls {
    compiling,  // all but those that reach other processes, the network, the kernel's rarer parts
    running,    // none but those that a program that computes and prints needs
};

bool has_system_call_filter();

// The filter's program for the process of that id; its instructions in bytes. Empty where this
// build has no libseccomp. Throws std::runtime_error where the filter cannot be made.
std::vector<unsigned char> system_call_filter(Calls calls, pid_t self);

// Puts the filter in force for the calling process, for good. False where the kernel refuses.
bool install_filter(const std::vector<unsigned char>& filter);

}  // namespace glint::grading
