#include "tests/grading/sandbox/system_calls.hpp"

#include <seccomp.h>

#include <cerrno>
#include <csignal>
#include <initializer_list>
#include <linux/filter.h>
#include <linux/seccomp.h>
#include <memory>
#include <stdexcept>
#include <sys/mman.h>
#include <sys/prctl.h>
#include <unistd.h>

namespace glint::grading {
namespace {

class Filter {
  public:
    explicit Filter(std::uint32_t otherwise) : context_(seccomp_init(otherwise)) {
        check(context_ != nullptr);
        // Calls by another architecture's numbers, int 0x80 among them, end the process.
        check(seccomp_attr_set(context_, SCMP_FLTATR_ACT_BADARCH, SCMP_ACT_KILL_PROCESS) == 0);
        check(seccomp_attr_set(context_, SCMP_FLTATR_CTL_OPTIMIZE, 2) == 0);
    }
    ~Filter() { seccomp_release(context_); }
    Filter(const Filter&) = delete;
    Filter& operator=(const Filter&) = delete;

    void add(std::uint32_t action, std::initializer_list<const char*> names) {
        for (const char* name : names) {
            add(action, name, {});
        }
    }
    // Calls that this architecture does not have need no rule.
    void add(std::uint32_t action, const char* name, std::initializer_list<scmp_arg_cmp> where) {
        const int call = seccomp_syscall_resolve_name(name);
        if (call >= 0) {
            check(seccomp_rule_add_array(context_, action, call,
                                         static_cast<unsigned>(where.size()), where.begin()) == 0);
        }
    }
    std::vector<unsigned char> program() const {
        const int file = memfd_create("filter", MFD_CLOEXEC);
        check(file >= 0 && seccomp_export_bpf(context_, file) == 0);
        std::vector<unsigned char> bytes(static_cast<std::size_t>(lseek(file, 0, SEEK_END)));
        const ssize_t got = pread(file, bytes.data(), bytes.size(), 0);
        close(file);
        check(got == static_cast<ssize_t>(bytes.size()) && !bytes.empty());
        return bytes;
    }

  private:
    static void check(bool worked) {
        if (!worked) {
            throw std::runtime_error("libseccomp cannot make the filter");
        }
    }
    scmp_filter_ctx context_;
};

scmp_arg_cmp argument(unsigned index, scmp_compare how, scmp_datum_t a, scmp_datum_t b = 0) {
    return {index, how, a, b};
}

// The compiler starts programs and writes files: where it may do so is Landlock's matter.
std::vector<unsigned char> compiling() {
    Filter f(SCMP_ACT_ALLOW);
    f.add(SCMP_ACT_ERRNO(EPERM), {"socket",
                                  "socketpair",
                                  "connect",
                                  "bind",
                                  "listen",
                                  "accept",
                                  "accept4",
                                  "sendto",
                                  "sendmsg",
                                  "ptrace",
                                  "process_vm_readv",
                                  "process_vm_writev",
                                  "pidfd_getfd",
                                  "kcmp",
                                  "kill",
                                  "tkill",
                                  "pidfd_send_signal",
                                  "keyctl",
                                  "add_key",
                                  "request_key",
                                  "bpf",
                                  "perf_event_open",
                                  "userfaultfd",
                                  "io_uring_setup",
                                  "io_uring_enter",
                                  "io_uring_register",
                                  "unshare",
                                  "setns",
                                  "mount",
                                  "umount2",
                                  "move_mount",
                                  "fsopen",
                                  "open_tree",
                                  "pivot_root",
                                  "chroot",
                                  "link",
                                  "linkat",
                                  "symlink",
                                  "symlinkat",
                                  "mknod",
                                  "mknodat",
                                  "shmget",
                                  "msgget",
                                  "semget",
                                  "mq_open",
                                  "setuid",
                                  "setgid",
                                  "setreuid",
                                  "setregid",
                                  "setresuid",
                                  "setresgid",
                                  "setgroups",
                                  "setfsuid",
                                  "setfsgid",
                                  "capset",
                                  "personality",
                                  "modify_ldt",
                                  "ioperm",
                                  "iopl",
                                  "init_module",
                                  "finit_module",
                                  "delete_module",
                                  "kexec_load",
                                  "kexec_file_load",
                                  "reboot",
                                  "swapon",
                                  "swapoff",
                                  "sethostname",
                                  "setdomainname",
                                  "settimeofday",
                                  "clock_settime",
                                  "adjtimex",
                                  "clock_adjtime",
                                  "syslog",
                                  "quotactl",
                                  "acct",
                                  "name_to_handle_at",
                                  "open_by_handle_at",
                                  "setsid",
                                  "setpgid"});
    return f.program();
}

// What a static C++ program calls, and a few that std::cout asks in vain. No file is opened, no
// process or thread made, no handler set that could outlive a timeout, no page made executable.
std::vector<unsigned char> running(pid_t self) {
    Filter f(SCMP_ACT_KILL_PROCESS);
    f.add(SCMP_ACT_ALLOW, {"read",       "write",        "readv",           "writev",
                           "brk",        "munmap",       "mremap",          "madvise",
                           "futex",      "rt_sigreturn", "rt_sigprocmask",  "exit",
                           "exit_group", "arch_prctl",   "set_tid_address", "set_robust_list",
                           "rseq",       "getrandom",    "clock_gettime",   "gettimeofday",
                           "getpid",     "gettid",       "restart_syscall"});
    f.add(SCMP_ACT_ERRNO(EPERM),
          {"fstat", "newfstatat", "ioctl", "lseek", "readlink", "readlinkat", "getcwd"});
    for (const char* call : {"mmap", "mprotect"}) {
        f.add(SCMP_ACT_ALLOW, call, {argument(2, SCMP_CMP_MASKED_EQ, PROT_EXEC, 0)});
    }
    f.add(SCMP_ACT_ALLOW, "prlimit64", {argument(0, SCMP_CMP_EQ, 0)});
    // abort() ends the process itself, and nobody else.
    f.add(SCMP_ACT_ALLOW, "tgkill",
          {argument(0, SCMP_CMP_EQ, static_cast<scmp_datum_t>(self)),
           argument(2, SCMP_CMP_EQ, SIGABRT)});
    // The program itself, which is then no longer open.
    f.add(SCMP_ACT_ALLOW, "execveat", {argument(0, SCMP_CMP_EQ, 5)});
    return f.program();
}

}  // namespace

bool has_system_call_filter() {
    return true;
}

std::vector<unsigned char> system_call_filter(Calls calls, pid_t self) {
    return calls == Calls::compiling ? compiling() : running(self);
}

bool install_filter(const std::vector<unsigned char>& filter) {
    // The kernel takes a pointer to instructions it does not write to.
    const sock_fprog program{
        static_cast<unsigned short>(filter.size() / sizeof(sock_filter)),
        reinterpret_cast<sock_filter*>(const_cast<unsigned char*>(filter.data()))};
    return prctl(PR_SET_SECCOMP, SECCOMP_MODE_FILTER, &program) == 0;
}

}  // namespace glint::grading
