#include "tests/grading/scratch.hpp"

#include "framework/math/error.hpp"
#include "tests/temporary.hpp"

#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

namespace glint::grading {
namespace {

pid_t grader = 0;

extern "C" void pass_on(int /*signal*/) {
    kill(grader, SIGTERM);
}

// What a shell's `nohup` or `&` has had ignored stays so.
void pass_on_signals() {
    for (const int number : {SIGINT, SIGTERM, SIGHUP}) {
        if (std::signal(number, pass_on) == SIG_IGN) {
            std::signal(number, SIG_IGN);
        }
    }
}

// For the grader, and for what it started: until that is gone there may be new files.
int wait_for_all() {
    int code = 0;
    int status = 0;
    for (pid_t ended = wait(&status); ended > 0 || errno == EINTR; ended = wait(&status)) {
        if (ended == grader) {
            code = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
        }
    }
    return code;
}

}  // namespace

int in_scratch(const std::function<int()>& grade) {
    const TemporaryFolder folder;
    setenv("TMPDIR", folder.path().c_str(), 1);
    prctl(PR_SET_CHILD_SUBREAPER, 1);  // the grader's children become this one's when it ends
    const pid_t self = getpid();
    grader = fork();
    if (grader < 0) {
        throw Error("no more processes can be started");
    }
    if (grader == 0) {
        end_with(self);
        std::exit(grade());
    }
    pass_on_signals();
    return wait_for_all();
}

void end_with(pid_t parent) {
    prctl(PR_SET_PDEATHSIG, SIGKILL);
    if (getppid() != parent) {
        std::raise(SIGKILL);
    }
}

}  // namespace glint::grading
