#include "tests/grading/doctor.hpp"

#include "tests/grading/archive.hpp"
#include "tests/grading/sandbox/confine.hpp"

#include <algorithm>
#include <csignal>
#include <stdexcept>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

namespace glint::grading {
namespace {

// Does a process under the filter die of a call that it may not make?
bool filter_works() {
    const pid_t child = fork();
    if (child == 0) {
        try {
            const auto filter = system_call_filter(Calls::running, getpid());
            if (!filter.empty() && prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0) == 0 &&
                install_filter(filter)) {
                getppid();
            }
        } catch (const std::exception&) {
            _exit(1);
        }
        _exit(1);
    }
    int status = 0;
    return child > 0 && waitpid(child, &status, 0) == child && WIFSIGNALED(status) &&
           WTERMSIG(status) == SIGSYS;
}

}  // namespace

std::vector<Protection> protections() {
    const bool filter = filter_works();
    const int landlock = landlock_version();
    const bool root = geteuid() == 0;
    return {
        {"system calls",
         filter ? "filtered by seccomp" : "not filtered: no libseccomp, or no kernel for it",
         filter, true},
        {"files",
         landlock > 0 ? "kept apart by Landlock, version " + std::to_string(landlock)
                      : "no Landlock: the compiler reads what its user may",
         landlock > 0, !root},
        {"user", root ? "another one for what is graded" : "the grader's own: root has another",
         root, false},
        {"archives", can_unzip() ? "read by unzip" : "zip is not read: install unzip", can_unzip(),
         false},
    };
}

bool is_protected(const std::vector<Protection>& all) {
    return std::all_of(all.begin(), all.end(),
                       [](const Protection& p) { return p.there || !p.needed; });
}

}  // namespace glint::grading
