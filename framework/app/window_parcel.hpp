// What the live window and the program that draws for it say to each other: parcels of bytes
// through a socket. Both are the same program, built at different times.
#pragma once

#include "framework/app/window_picture.hpp"

#include <chrono>
#include <cstring>
#include <optional>
#include <string>
#include <type_traits>
#include <vector>

namespace glint {

class Parcel {
  public:
    explicit Parcel(std::string bytes = "") : bytes_(std::move(bytes)) {}
    const std::string& bytes() const { return bytes_; }

    template <class T>
    requires std::is_trivially_copyable_v<T>
    void put(const T& value) { bytes_.append(reinterpret_cast<const char*>(&value), sizeof value); }
    template <class T>
    void put(const std::vector<T>& values) {
        put(values.size());
        for (const T& value : values) {
            put(value);
        }
    }
    void put(const std::string& text);
    void put(const Seen::Label& label);
    void put(const Seen& seen);
    void put(const PictureState& state);

    // In the order in which they were put. Error where there is no more.
    template <class T>
    requires std::is_trivially_copyable_v<T>
    void take(T& value) { std::memcpy(&value, take_bytes(sizeof value), sizeof value); }
    template <class T>
    void take(std::vector<T>& values) {
        std::size_t count = 0;
        take(count);
        values.clear();
        for (std::size_t i = 0; i < count; ++i) {
            take(values.emplace_back());
        }
    }
    void take(std::string& text);
    void take(Seen::Label& label);
    void take(Seen& seen);
    void take(PictureState& state);

  private:
    const char* take_bytes(std::size_t count);

    std::string bytes_;
    std::size_t taken_ = 0;
};

// What the user did, on its way to another program.
struct PictureEvent {
    enum class Kind { resize, action, gesture, zoom, forget_probe, redraw };
    Kind kind = Kind::redraw;
    Action action{};
    Gesture gesture{};
    float steps = 0;
    int width = 0, height = 0;
};

using Deadline = std::chrono::steady_clock::time_point;

// False where the other side is gone, or does not take it in time.
bool send_parcel(int socket, const Parcel& parcel, Deadline deadline);

// None where the other side is gone, or says nothing in time.
std::optional<Parcel> receive_parcel(int socket, Deadline deadline);

}  // namespace glint
