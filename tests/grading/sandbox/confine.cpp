#include "tests/grading/sandbox/confine.hpp"

#include "tests/grading/sandbox/enter.hpp"

#include <array>
#include <cerrno>
#include <csignal>
#include <cstring>
#include <fcntl.h>
#include <poll.h>
#include <stdexcept>
#include <sys/resource.h>
#include <sys/wait.h>
#include <thread>
#include <unistd.h>
#include <utility>

namespace glint::grading {
namespace {

using Clock = std::chrono::steady_clock;

[[noreturn]] void fail(const std::string& what) {
    throw std::runtime_error(what + ": " + std::strerror(errno));
}

// A file descriptor that closes itself.
class File {
  public:
    explicit File(int number = -1) : number_(number) {}
    File(File&& other) noexcept : number_(std::exchange(other.number_, -1)) {}
    File& operator=(File&& other) noexcept {
        std::swap(number_, other.number_);
        return *this;
    }
    ~File() { shut(); }
    File(const File&) = delete;
    File& operator=(const File&) = delete;

    int number() const { return number_; }
    bool is_open() const { return number_ >= 0; }
    void shut() {
        if (is_open()) {
            close(std::exchange(number_, -1));
        }
    }

  private:
    int number_;
};

File opened(const std::filesystem::path& path, int how) {
    File file(open(path.c_str(), how | O_CLOEXEC));
    if (!file.is_open()) {
        fail(path.string());
    }
    return file;
}

struct Pipe {
    File read, write;
    Pipe() {
        std::array<int, 2> ends{};
        if (pipe2(ends.data(), O_CLOEXEC) != 0) {
            fail("pipe2");
        }
        read = File(ends[0]);
        write = File(ends[1]);
    }
};

void do_not_wait(const File& file) {
    fcntl(file.number(), F_SETFL, fcntl(file.number(), F_GETFL) | O_NONBLOCK);
}

// What the child writes, up to a limit.
class Collector {
  public:
    Collector(File from, std::size_t most) : from_(std::move(from)), most_(most) {
        do_not_wait(from_);
    }
    const File& file() const { return from_; }
    bool overfull() const { return text_.size() > most_; }
    std::string take() { return std::move(text_).substr(0, most_); }

    void read_some() {
        std::array<char, 65536> buffer{};
        const ssize_t got = read(from_.number(), buffer.data(), buffer.size());
        if (got > 0) {
            text_.append(buffer.data(), std::min(static_cast<std::size_t>(got),
                                                 most_ + 1 - std::min(most_ + 1, text_.size())));
        } else if (got == 0 || (errno != EAGAIN && errno != EINTR)) {
            from_.shut();
        }
    }

  private:
    File from_;
    std::string text_;
    std::size_t most_;
};

// What the child reads.
class Feeder {
  public:
    Feeder(File to, std::string text) : to_(std::move(to)), text_(std::move(text)) {
        do_not_wait(to_);
        shut_if_done();
    }
    const File& file() const { return to_; }

    void write_some() {
        const ssize_t put = write(to_.number(), text_.data() + done_, text_.size() - done_);
        if (put >= 0) {
            done_ += static_cast<std::size_t>(put);
            shut_if_done();
        } else if (errno != EAGAIN && errno != EINTR) {
            to_.shut();  // the child reads no more: its own loss
        }
    }

  private:
    void shut_if_done() {
        if (done_ == text_.size()) {
            to_.shut();
        }
    }
    File to_;
    std::string text_;
    std::size_t done_ = 0;
};

// Talks with the child until all its ends are shut, time is up, or it has said too much. The last
// collector is not limited by the child's will.
bool talk(Feeder& feeder, std::array<Collector*, 3> collectors, Clock::time_point end) {
    for (;;) {
        std::array<pollfd, 4> waits{};
        waits[0] = {feeder.file().number(), POLLOUT, 0};
        bool open = feeder.file().is_open();
        for (std::size_t i = 0; i < collectors.size(); ++i) {
            waits[i + 1] = {collectors[i]->file().number(), POLLIN, 0};
            open = open || collectors[i]->file().is_open();
            if (collectors[i]->overfull()) {
                return true;
            }
        }
        const auto left = std::chrono::ceil<std::chrono::milliseconds>(end - Clock::now()).count();
        if (!open || left <= 0) {
            return true;
        }
        if (poll(waits.data(), waits.size(), static_cast<int>(left)) < 0 && errno != EINTR) {
            return false;
        }
        if (waits[0].revents != 0) {
            feeder.write_some();
        }
        for (std::size_t i = 0; i < collectors.size(); ++i) {
            if (waits[i + 1].revents != 0) {
                collectors[i]->read_some();
            }
        }
    }
}

// Ended by itself before the time? It is left to be waited for, so that its id stays its own.
bool ends_before(pid_t child, Clock::time_point end) {
    using namespace std::chrono_literals;
    for (;;) {
        siginfo_t info{};
        if (waitid(P_PID, static_cast<id_t>(child), &info, WEXITED | WNOHANG | WNOWAIT) == 0 &&
            info.si_pid == child) {
            return true;
        }
        if (Clock::now() >= end) {
            return false;
        }
        std::this_thread::sleep_for(200us);
    }
}

double seconds_of(const rusage& used) {
    const auto of = [](const timeval& t) {
        return static_cast<double>(t.tv_sec) + 1e-6 * static_cast<double>(t.tv_usec);
    };
    return of(used.ru_utime) + of(used.ru_stime);
}

struct Gone {
    int status;
    double seconds;
};

// Ends the child's group, and waits for the child.
Gone end_group(pid_t child) {
    kill(-child, SIGKILL);
    kill(child, SIGKILL);  // before it has a group of its own
    int status = 0;
    rusage used{};
    while (wait4(child, &status, 0, &used) < 0) {
        if (errno != EINTR) {
            fail("wait4");
        }
    }
    return {status, seconds_of(used)};
}

}  // namespace

std::optional<uid_t> nobodys_user() {
    constexpr uid_t first = 61000;  // beyond what Debian gives to people and services
    return geteuid() == 0 ? std::optional<uid_t>(first + static_cast<uid_t>(getpid()) % 4000)
                          : std::nullopt;
}

Ended run_confined(const Program& program, const Confinement& c) {
    signal(SIGPIPE, SIG_IGN);
    const File null = opened("/dev/null", O_RDWR);
    const File executable = opened(program.file, O_RDONLY);
    Pipe input;
    Pipe output;
    Pipe diagnostics;
    Pipe trouble;
    const pid_t self = getpid();
    const Clock::time_point end = Clock::now() + c.limits.wall;
    const pid_t child = fork();
    if (child < 0) {
        fail("fork");
    }
    if (child == 0) {
        enter(program, c,
              {null.number(), diagnostics.write.number(), input.read.number(),
               output.write.number(), executable.number(), trouble.write.number()},
              self);
    }
    input.read.shut();
    output.write.shut();
    diagnostics.write.shut();
    trouble.write.shut();
    Feeder feeder(std::move(input.write), program.input);
    Collector said(std::move(output.read), c.limits.output);
    Collector muttered(std::move(diagnostics.read), c.limits.diagnostics);
    Collector complained(std::move(trouble.read), 256);
    const bool talked = talk(feeder, {&said, &muttered, &complained}, end);
    const bool overfull = said.overfull() || muttered.overfull();
    const bool in_time = overfull || ends_before(child, end);
    const Gone gone = end_group(child);
    const std::string step = complained.take();
    if (!talked || (!step.empty() && step != no_room)) {
        throw std::runtime_error("the sandbox cannot be entered: " + step);
    }
    const Ended::How how = !step.empty()              ? Ended::How::not_started
                           : overfull                 ? Ended::How::output_limit
                           : !in_time                 ? Ended::How::out_of_time
                           : WIFSIGNALED(gone.status) ? Ended::How::signalled
                                                      : Ended::How::exited;
    return {how, WIFSIGNALED(gone.status) ? WTERMSIG(gone.status) : WEXITSTATUS(gone.status),
            said.take(), muttered.take(), gone.seconds};
}

}  // namespace glint::grading
