#include "tests/grading/digest.hpp"

#include <array>
#include <openssl/evp.h>
#include <openssl/hmac.h>
#include <stdexcept>

namespace glint::grading {
namespace {

using Digest = std::array<unsigned char, 32>;

void demand(bool worked) {
    if (!worked) {
        throw std::runtime_error("libcrypto has no SHA-256");
    }
}

}  // namespace

std::string sha256(const std::string& text) {
    Digest digest{};
    demand(EVP_Digest(text.data(), text.size(), digest.data(), nullptr, EVP_sha256(), nullptr) ==
           1);
    std::string hexadecimal;
    for (const unsigned char byte : digest) {
        hexadecimal += "0123456789abcdef"[byte >> 4];
        hexadecimal += "0123456789abcdef"[byte & 15];
    }
    return hexadecimal;
}

std::uint64_t seed(const std::string& secret, const std::string& text) {
    Digest digest{};
    unsigned length = 0;
    demand(HMAC(EVP_sha256(), secret.data(), static_cast<int>(secret.size()),
                reinterpret_cast<const unsigned char*>(text.data()), text.size(), digest.data(),
                &length) != nullptr &&
           length == digest.size());
    std::uint64_t bits = 0;
    for (std::size_t i = 0; i < 8; ++i) {
        bits = bits << 8 | digest[i];
    }
    return bits;
}

}  // namespace glint::grading
