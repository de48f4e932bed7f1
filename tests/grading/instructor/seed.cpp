#include "tests/grading/instructor/seed.hpp"

#include "framework/math/error.hpp"

#include <array>
#include <openssl/evp.h>
#include <openssl/hmac.h>

namespace glint::grading {

std::uint64_t seed(const std::string& secret, const std::string& text) {
    std::array<unsigned char, 32> digest{};
    unsigned length = 0;
    if (HMAC(EVP_sha256(), secret.data(), static_cast<int>(secret.size()),
             reinterpret_cast<const unsigned char*>(text.data()), text.size(), digest.data(),
             &length) == nullptr ||
        length != digest.size()) {
        throw Error("libcrypto has no HMAC-SHA256");
    }
    std::uint64_t bits = 0;
    for (int i = 0; i < 8; ++i) {
        bits = bits << 8 | digest[static_cast<std::size_t>(i)];
    }
    return bits;
}

}  // namespace glint::grading
