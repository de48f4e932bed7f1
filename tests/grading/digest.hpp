// SHA-256, and numbers from it that only the holder of a secret can foretell.
#pragma once

#include <cstdint>
#include <string>

namespace glint::grading {

// 64 hexadecimal digits.
std::string sha256(const std::string& text);

// The first 64 bits of HMAC-SHA256 of the text.
std::uint64_t seed(const std::string& secret, const std::string& text);

}  // namespace glint::grading
