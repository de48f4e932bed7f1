// What passes between the grader and the runner, both on this machine: a head, then doubles.
#pragma once

#include <cstdint>

namespace glint::grading {

// What the student's functions are called with.
enum class Number : std::uint32_t { as_double, as_float, as_lanes };

// Followed by rows x columns numbers.
struct Request {
    static constexpr std::uint64_t sign = 0x746e696c67206b61;
    std::uint64_t head = sign;
    std::uint64_t tag;  // never the same
    std::uint32_t task;
    Number number;
    std::uint32_t rows, columns, answers_a_row, reserved = 0;
};

// Followed by rows x answers_a_row numbers.
struct Reply {
    std::uint64_t tag, rows;
};

// What makes a reply's tag of the request's: nothing secret, but nothing that comes by itself.
inline std::uint64_t reply_tag(std::uint64_t tag) {
    return ~(tag << 13 | tag >> 51);
}

}  // namespace glint::grading
