// A grader that leaves nothing behind, however it ends.
#pragma once

#include <functional>
#include <sys/types.h>

namespace glint::grading {

// Grades in a process of its own, whose temporary folders lie in one that goes with it; returns its
// exit code. Interrupted, terminated or hung up on, ends it and waits for all that it started.
int in_scratch(const std::function<int()>& grade);

// To be called by a child: it is killed where its parent ends.
void end_with(pid_t parent);

}  // namespace glint::grading
