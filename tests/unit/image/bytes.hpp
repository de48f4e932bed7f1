// Bytes from text and from numbers, to make files that no writer of ours would.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace glint {

using Bytes = std::vector<std::byte>;

inline Bytes bytes_of(const std::string& text) {
    const auto* first = reinterpret_cast<const std::byte*>(text.data());
    return {first, first + text.size()};
}

inline Bytes operator+(Bytes a, const Bytes& b) {
    a.insert(a.end(), b.begin(), b.end());
    return a;
}

// The last count bytes of a number, the most significant first.
inline Bytes big_endian(std::uint32_t number, int count = 4) {
    Bytes bytes;
    for (int shift = 8 * (count - 1); shift >= 0; shift -= 8) {
        bytes.push_back(static_cast<std::byte>(number >> shift));
    }
    return bytes;
}

inline Bytes little_endian(std::uint32_t number, int count = 4) {
    const Bytes bytes = big_endian(number, count);
    return {bytes.rbegin(), bytes.rend()};
}

}  // namespace glint
