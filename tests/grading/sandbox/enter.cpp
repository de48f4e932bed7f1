#include "tests/grading/sandbox/enter.hpp"

#include <array>
#include <cerrno>
#include <csignal>
#include <cstring>
#include <exception>
#include <fcntl.h>
#include <grp.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <sys/time.h>
#include <unistd.h>

namespace glint::grading {
namespace {

constexpr int trouble = 6;  // its place among the child's descriptors

[[noreturn]] void fail(const char* step) {
    const ssize_t ignored = write(trouble, step, std::strlen(step));
    _exit(ignored > 0 ? 126 : 127);
}

void demand(bool worked, const char* step) {
    if (!worked) {
        fail(step);
    }
}

// Moved above all places first, so that none is closed before it is moved.
void place_descriptors(const ChildEnds& ends) {
    std::array<int, 7> from{ends.null,   ends.diagnostics, ends.diagnostics, ends.input,
                            ends.output, ends.program,     ends.trouble};
    for (int& end : from) {
        end = fcntl(end, F_DUPFD, 100);
        demand(end >= 0, "fcntl");
    }
    for (int place = 0; place < static_cast<int>(from.size()); ++place) {
        demand(dup2(from[static_cast<std::size_t>(place)], place) == place, "dup2");
    }
    // The program's own descriptor and trouble's are gone once it runs.
    demand(fcntl(5, F_SETFD, FD_CLOEXEC) == 0 && fcntl(trouble, F_SETFD, FD_CLOEXEC) == 0, "fcntl");
    if (syscall(SYS_close_range, trouble + 1, ~0U, 0) != 0) {  // Linux 5.9
        const long most = sysconf(_SC_OPEN_MAX);
        for (int file = trouble + 1; file < (most > 0 && most < 65536 ? most : 65536); ++file) {
            close(file);
        }
    }
}

void forget_signals() {
    for (int signal = 1; signal < NSIG; ++signal) {
        ::signal(signal, SIG_DFL);
    }
    sigset_t none;
    sigemptyset(&none);
    demand(sigprocmask(SIG_SETMASK, &none, nullptr) == 0, "sigprocmask");
}

void limit(__rlimit_resource what, std::size_t most) {
    const rlimit both{most, most};
    demand(setrlimit(what, &both) == 0, "setrlimit");
}

void limit_resources(const Limits& limits, bool own_user) {
    const auto seconds = std::chrono::ceil<std::chrono::seconds>(limits.processor).count();
    limit(RLIMIT_CPU, static_cast<std::size_t>(seconds) + 1);
    limit(RLIMIT_FSIZE, limits.file_size);
    limit(RLIMIT_STACK, limits.stack);
    limit(RLIMIT_CORE, 0);
    limit(RLIMIT_NOFILE, 64);
    limit(RLIMIT_MEMLOCK, 0);
    limit(RLIMIT_MSGQUEUE, 0);
    if (own_user) {  // else it would count what else the user runs
        limit(RLIMIT_NPROC, 64);
    }
    limit(RLIMIT_AS, limits.memory);
}

// Survives exec, though not fork.
void start_timer(std::chrono::milliseconds time) {
    const auto whole = std::chrono::floor<std::chrono::seconds>(time);
    const std::chrono::microseconds rest = time - whole;
    const itimerval once{{0, 0}, {whole.count(), rest.count()}};
    demand(setitimer(ITIMER_PROF, &once, nullptr) == 0, "setitimer");
}

void become(uid_t user) {
    demand(setgroups(0, nullptr) == 0, "setgroups");
    demand(setresgid(user, user, user) == 0, "setresgid");
    demand(setresuid(user, user, user) == 0, "setresuid");
    demand(getuid() == user && geteuid() == user && setuid(0) != 0, "setuid");
}

std::vector<char*> pointers_to(std::vector<std::string>& words) {
    std::vector<char*> all;
    all.reserve(words.size() + 1);
    for (std::string& word : words) {
        all.push_back(word.data());
    }
    all.push_back(nullptr);
    return all;
}

}  // namespace

void enter(const Program& program, const Confinement& c, const ChildEnds& ends, pid_t parent) {
    try {
        place_descriptors(ends);
        demand(setsid() == getpid(), "setsid");
        forget_signals();
        umask(077);
        // All that needs memory comes before the limits.
        const std::vector<unsigned char> filter = system_call_filter(c.calls, getpid());
        std::vector<std::string> words{program.file.string()};
        words.insert(words.end(), program.arguments.begin(), program.arguments.end());
        const std::vector<char*> arguments = pointers_to(words);
        std::vector<std::string> settings = program.environment;
        const std::vector<char*> environment = pointers_to(settings);

        demand(chdir(c.folder.c_str()) == 0, "chdir");
        if (c.user) {
            become(*c.user);
        }
        demand(prctl(PR_SET_PDEATHSIG, SIGKILL) == 0 && getppid() == parent, "parent");
        demand(prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0) == 0, "no_new_privs");
        demand(!c.reach || keep_within(*c.reach), "landlock");
        limit_resources(c.limits, c.user.has_value());
        start_timer(c.limits.processor);
        demand(install_filter(filter), "seccomp");
        syscall(SYS_execveat, 5, "", arguments.data(), environment.data(), AT_EMPTY_PATH);
        fail(errno == ENOMEM ? no_room : "execveat");
    } catch (const std::exception& e) {
        fail(e.what());
    }
}

}  // namespace glint::grading
