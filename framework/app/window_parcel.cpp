#include "framework/app/window_parcel.hpp"

#include "framework/math/error.hpp"

#include <algorithm>
#include <cstdint>
#include <poll.h>
#include <sys/socket.h>

namespace glint {
namespace {

using std::chrono::milliseconds;

// Until the socket is ready, a minute at a time: poll() counts in ints.
bool wait_until_ready(int socket, short events, Deadline deadline) {
    for (;;) {
        const auto left = std::chrono::ceil<milliseconds>(deadline - Deadline::clock::now());
        pollfd waiting{socket, events, 0};
        if (left.count() <= 0) {
            return false;
        }
        const auto ms = static_cast<int>(std::min<std::int64_t>(left.count(), 60'000));
        if (poll(&waiting, 1, ms) > 0) {
            return true;
        }
    }
}

bool send_all(int socket, const char* from, std::size_t size, Deadline deadline) {
    while (size > 0) {
        if (!wait_until_ready(socket, POLLOUT, deadline)) {
            return false;
        }
        const ssize_t put = send(socket, from, size, MSG_NOSIGNAL | MSG_DONTWAIT);
        if (put <= 0) {
            return false;
        }
        from += put;
        size -= static_cast<std::size_t>(put);
    }
    return true;
}

bool receive_all(int socket, char* to, std::size_t size, Deadline deadline) {
    while (size > 0) {
        if (!wait_until_ready(socket, POLLIN, deadline)) {
            return false;
        }
        const ssize_t got = recv(socket, to, size, MSG_DONTWAIT);
        if (got <= 0) {
            return false;
        }
        to += got;
        size -= static_cast<std::size_t>(got);
    }
    return true;
}

}  // namespace

const char* Parcel::take_bytes(std::size_t count) {
    if (count > bytes_.size() - taken_) {
        throw Error("the program that draws says too little");
    }
    const char* at = bytes_.data() + taken_;
    taken_ += count;
    return at;
}

void Parcel::put(const std::string& text) {
    put(text.size());
    bytes_ += text;
}
void Parcel::take(std::string& text) {
    std::size_t size = 0;
    take(size);
    text.assign(take_bytes(size), size);
}

void Parcel::put(const Seen::Label& label) {
    put(label.left);
    put(label.words);
}
void Parcel::take(Seen::Label& label) {
    take(label.left);
    take(label.words);
}

void Parcel::put(const Seen& seen) {
    put(seen.picture.width());
    put(seen.picture.height());
    const auto pixels = seen.picture.pixels();
    bytes_.append(reinterpret_cast<const char*>(pixels.data()), pixels.size_bytes());
    put(seen.status);
    put(seen.labels);
    put(seen.report);
}
void Parcel::take(Seen& seen) {
    int width = 0;
    int height = 0;
    take(width);
    take(height);
    seen.picture = SrgbImage(std::max(width, 0), std::max(height, 0));
    const auto pixels = seen.picture.pixels();
    std::copy_n(take_bytes(pixels.size_bytes()), pixels.size_bytes(),
                reinterpret_cast<char*>(pixels.data()));
    take(seen.status);
    take(seen.labels);
    take(seen.report);
}

void Parcel::put(const PictureState& s) {
    put(s.width);
    put(s.height);
    put(s.settings);
    put(s.view);
    put(s.probe_x);
    put(s.probe_y);
    put(s.chosen_parameter);
    put(s.parameters);
    put(s.views);
}
void Parcel::take(PictureState& s) {
    take(s.width);
    take(s.height);
    take(s.settings);
    take(s.view);
    take(s.probe_x);
    take(s.probe_y);
    take(s.chosen_parameter);
    take(s.parameters);
    take(s.views);
}

bool send_parcel(int socket, const Parcel& parcel, Deadline deadline) {
    const std::uint64_t size = parcel.bytes().size();
    return send_all(socket, reinterpret_cast<const char*>(&size), sizeof size, deadline) &&
           send_all(socket, parcel.bytes().data(), size, deadline);
}

std::optional<Parcel> receive_parcel(int socket, Deadline deadline) {
    constexpr std::uint64_t most = std::uint64_t{1} << 32;
    std::uint64_t size = 0;
    if (!receive_all(socket, reinterpret_cast<char*>(&size), sizeof size, deadline) ||
        size > most) {
        return std::nullopt;
    }
    std::string bytes(size, '\0');
    if (!receive_all(socket, bytes.data(), size, deadline)) {
        return std::nullopt;
    }
    return Parcel(std::move(bytes));
}

}  // namespace glint
