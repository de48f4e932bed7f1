#include "framework/app/window_remote.hpp"

#include "framework/image/file.hpp"
#include "framework/math/error.hpp"

#include <algorithm>
#include <csignal>
#include <cstdlib>
#include <fcntl.h>
#include <iostream>
#include <spawn.h>
#include <string>
#include <string_view>
#include <sys/prctl.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>
#include <utility>

namespace glint {
namespace {

using namespace std::chrono_literals;

constexpr int drawing_socket = 3;  // of the program that draws
constexpr auto patience = 4s;      // for a picture
constexpr const char* role = "GLINT_WATCH";

bool has_role(std::string_view wanted) {
    const char* is = std::getenv(role);
    return is != nullptr && is == wanted;
}

// As this program was called.
std::vector<std::string> arguments() {
    const std::string all = read_text("/proc/self/cmdline");
    std::vector<std::string> words;
    for (std::size_t at = 0; at < all.size(); at += words.back().size() + 1) {
        words.emplace_back(all.c_str() + at);
    }
    return words;
}

std::string how_it_ended(int status) {
    if (WIFSIGNALED(status)) {
        return std::string("your program crashed: ") + strsignal(WTERMSIG(status));
    }
    return "your program ended by itself, with status " + std::to_string(WEXITSTATUS(status));
}

void apply(LivePicture& live, const PictureEvent& e) {
    switch (e.kind) {
        case PictureEvent::Kind::resize:
            return live.resize(e.width, e.height);
        case PictureEvent::Kind::action:
            return live.act(e.action);
        case PictureEvent::Kind::gesture:
            return live.act(e.gesture);
        case PictureEvent::Kind::zoom:
            return live.zoom_steps(e.steps);
        case PictureEvent::Kind::forget_probe:
            return live.forget_probe();
        case PictureEvent::Kind::redraw:
            return live.redraw();
    }
}

}  // namespace

// ---- the side of the window ------------------------------------------------------------------

RemotePicture::RemotePicture(Options options) : options_(std::move(options)) {
    start();
}

RemotePicture::~RemotePicture() {
    stop();
}

// Returns how it ended.
int RemotePicture::stop() {
    int status = 0;
    if (program_ > 0) {
        kill(program_, SIGKILL);
        waitpid(program_, &status, 0);
        close(socket_);
        program_ = -1;
    }
    return status;
}

void RemotePicture::start() {
    int sockets[2];
    if (socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, sockets) != 0) {
        throw Error("there are no more files to be had for the window");
    }
    std::vector<std::string> words = arguments();
    std::vector<char*> argv;
    argv.reserve(words.size() + 1);
    for (std::string& word : words) {
        argv.push_back(word.data());
    }
    argv.push_back(nullptr);
    posix_spawn_file_actions_t files;
    posix_spawn_file_actions_init(&files);
    posix_spawn_file_actions_addopen(&files, 0, "/dev/null", O_RDONLY, 0);
    posix_spawn_file_actions_adddup2(&files, sockets[1], drawing_socket);
    setenv(role, "draw", 1);
    const int failed = posix_spawn(&program_, argv[0], &files, nullptr, argv.data(), environ);
    setenv(role, "window", 1);
    posix_spawn_file_actions_destroy(&files);
    close(sockets[1]);
    socket_ = sockets[0];
    fresh_ = true;
    if (failed != 0) {
        close(socket_);
        program_ = -1;
        seen_.status = {"your program does not start"};
    }
}

// The last picture stays, with the reason that there is no other.
void RemotePicture::give_up(bool in_time) {
    // Who closed the socket is about to end: what ends it is its word, not ours.
    siginfo_t info{};
    for (int i = 0; in_time && info.si_pid == 0 && i < 100; ++i) {
        usleep(10'000);
        waitid(P_PID, static_cast<id_t>(program_), &info, WEXITED | WNOHANG | WNOWAIT);
    }
    const int status = stop();
    seen_.status = {
        in_time ? how_it_ended(status) : "your program took longer than 4 s for a picture: ended",
        "the picture is the last one that there was"};
    seen_.report.clear();
    std::cerr << seen_.status.front() << '\n';
}

void RemotePicture::restart() {
    stop();
    start();
    stale_ = true;
}

const Seen& RemotePicture::seen() {
    if (std::exchange(stale_, false)) {
        if (program_ > 0) {
            ask();
        }
        fit();
    }
    return seen_;
}

void RemotePicture::ask() {
    Parcel question;
    question.put(fresh_ && state_.has_value());
    if (fresh_ && state_) {
        question.put(*state_);
    }
    question.put(events_);
    const Deadline deadline = Deadline::clock::now() + patience;
    const bool sent = send_parcel(socket_, question, deadline);
    std::optional<Parcel> answer = sent ? receive_parcel(socket_, deadline) : std::nullopt;
    if (!answer) {
        return give_up(Deadline::clock::now() < deadline);
    }
    answer->take(seen_);
    PictureState state{};
    answer->take(state);
    options_.probe.reset();
    if (state.probe_x >= 0) {
        options_.probe = {state.probe_x, state.probe_y};
    }
    state_ = state;
    events_.clear();
    fresh_ = false;
}

// A picture of before has the window's size of before.
void RemotePicture::fit() {
    if (seen_.picture.width() == options_.width && seen_.picture.height() == options_.height) {
        return;
    }
    SrgbImage fitted(options_.width, options_.height, Rgba8{0, 0, 0, 255});
    const int width = std::min(fitted.width(), seen_.picture.width());
    for (int y = 0; y < std::min(fitted.height(), seen_.picture.height()); ++y) {
        std::copy_n(seen_.picture.row(y).begin(), width, fitted.row(y).begin());
    }
    seen_.picture = std::move(fitted);
}

void RemotePicture::note(const PictureEvent& event) {
    events_.push_back(event);
    stale_ = true;
}

void RemotePicture::resize(int width, int height) {
    if (width < 1 || height < 1 || (width == options_.width && height == options_.height)) {
        return;
    }
    options_.width = width;
    options_.height = height;
    options_.probe.reset();
    note({.kind = PictureEvent::Kind::resize, .width = width, .height = height});
}

void RemotePicture::act(Action action) {
    note({.kind = PictureEvent::Kind::action, .action = action});
}

void RemotePicture::act(const Gesture& gesture) {
    if (gesture.kind != Gesture::Kind::none) {
        note({.kind = PictureEvent::Kind::gesture, .gesture = gesture});
    }
}

void RemotePicture::zoom_steps(float steps) {
    note({.kind = PictureEvent::Kind::zoom, .steps = steps});
}

void RemotePicture::forget_probe() {
    options_.probe.reset();
    note({.kind = PictureEvent::Kind::forget_probe});
}

void RemotePicture::redraw() {
    note({.kind = PictureEvent::Kind::redraw});
}

// ---- the side of the program that draws ------------------------------------------------------

bool draws_for_window() {
    return has_role("draw");
}

bool window_is_watched() {
    return has_role("window");
}

int draw_for_window(const Lesson& lesson, const Options& options) {
    prctl(PR_SET_PDEATHSIG, SIGKILL);  // in an endless loop nobody sees that the window is gone
    LivePicture live(lesson, options);
    while (std::optional<Parcel> question = receive_parcel(drawing_socket, Deadline::max())) {
        bool restores = false;
        question->take(restores);
        if (restores) {
            PictureState state{};
            question->take(state);
            live.restore(state);
        }
        std::vector<PictureEvent> events;
        question->take(events);
        for (const PictureEvent& event : events) {
            apply(live, event);
        }
        Parcel answer;
        answer.put(live.seen());
        answer.put(live.state());
        if (!send_parcel(drawing_socket, answer, Deadline::max())) {
            break;
        }
    }
    return 0;
}

}  // namespace glint
