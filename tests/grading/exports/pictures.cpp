#include "tests/grading/exports/pictures.hpp"

#include "framework/image/png.hpp"

namespace glint::grading {
namespace {

// RFC 4648: three bytes are four letters of six bits.
std::string base64(const std::vector<std::byte>& bytes) {
    constexpr std::string_view letters =
        "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string text;
    for (std::size_t i = 0; i < bytes.size(); i += 3) {
        unsigned bits = 0;
        for (std::size_t j = i; j < i + 3; ++j) {
            bits = bits << 8 | (j < bytes.size() ? std::to_integer<unsigned>(bytes[j]) : 0);
        }
        for (std::size_t j = 0; j < 4; ++j) {
            text += i + j > bytes.size() ? '=' : letters[bits >> (18 - 6 * j) & 63];
        }
    }
    return text;
}

}  // namespace

bool has_picture(const CaseResult& c) {
    return c.shown && !c.shown->picture.empty();
}

std::string picture_url(const CaseResult& c) {
    return "data:image/png;base64," + base64(encode_png(c.shown->picture));
}

std::string raster_of(const CaseResult& c) {
    return c.shown && !c.shown->raster.empty() && c.verdict != Verdict::ok
               ? c.shown->raster + "# covered, ! too much, ? missing\n"
               : "";
}

}  // namespace glint::grading
