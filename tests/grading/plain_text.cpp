#include "tests/grading/plain_text.hpp"

namespace glint::grading {
namespace {

// The bytes of the character that the text starts with; 0 where it is no UTF-8. RFC 3629: the
// shortest form only, no surrogates, nothing beyond U+10FFFF.
std::size_t character_size(std::string_view text) {
    const auto byte = [&](std::size_t i) -> unsigned {
        return i < text.size() ? static_cast<unsigned char>(text[i]) : 0;
    };
    const unsigned first = byte(0);
    const std::size_t size = first < 0x80                     ? 1
                             : first >= 0xc2 && first <= 0xdf ? 2
                             : first >= 0xe0 && first <= 0xef ? 3
                             : first >= 0xf0 && first <= 0xf4 ? 4
                                                              : 0;
    for (std::size_t i = 1; i < size; ++i) {
        if ((byte(i) & 0xc0) != 0x80) {
            return 0;
        }
    }
    const bool wrong = (first == 0xe0 && byte(1) < 0xa0) || (first == 0xed && byte(1) > 0x9f) ||
                       (first == 0xf0 && byte(1) < 0x90) || (first == 0xf4 && byte(1) > 0x8f);
    return wrong ? 0 : size;
}

// Terminals act on these, U+0080..U+009F and the marks that turn the direction of writing among
// them.
bool is_control(std::string_view c) {
    const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(c[i]); };
    if (c.size() == 1) {
        return (byte(0) < 0x20 && c != "\n" && c != "\t") || byte(0) == 0x7f;
    }
    return (c.size() == 2 && byte(0) == 0xc2 && byte(1) < 0xa0) ||
           (c.size() == 3 && byte(0) == 0xe2 &&
            ((byte(1) == 0x80 && byte(2) >= 0xaa && byte(2) <= 0xae) ||
             (byte(1) == 0x81 && byte(2) >= 0xa6 && byte(2) <= 0xa9)));
}

}  // namespace

bool is_plain_text(std::string_view text) {
    while (!text.empty()) {
        const std::size_t size = character_size(text);
        if (size == 0 || text.front() == '\0') {
            return false;
        }
        text.remove_prefix(size);
    }
    return true;
}

std::string printable(std::string_view text, std::size_t limit) {
    std::string out;
    while (!text.empty()) {
        const std::size_t size = character_size(text);
        const std::string_view c = text.substr(0, size == 0 ? 1 : size);
        if (out.size() + c.size() > limit) {
            return out + "...";
        }
        out += size == 0 || is_control(c) ? std::string_view("?") : c;
        text.remove_prefix(c.size());
    }
    return out;
}

std::string shell_word(std::string_view text) {
    std::string word = "'";
    for (const char c : text) {
        word += c == '\'' ? "'\\''" : std::string(1, c);
    }
    return word + '\'';
}

}  // namespace glint::grading
