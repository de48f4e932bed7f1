#include "framework/geometry/obj_spelling.hpp"

#include <algorithm>
#include <set>
#include <string>

namespace glint {
namespace {

bool is_digit(char c) {
    return c >= '0' && c <= '9';
}

bool is_letter(char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_';
}

std::size_t take_digits(std::string_view& word) {
    const auto end = std::find_if_not(word.begin(), word.end(), is_digit);
    const auto count = static_cast<std::size_t>(end - word.begin());
    word.remove_prefix(count);
    return count;
}

bool take_any(std::string_view& word, std::string_view characters) {
    if (word.empty() || characters.find(word.front()) == std::string_view::npos) {
        return false;
    }
    word.remove_prefix(1);
    return true;
}

// A file of 2 GiB has fewer vertices than nine digits can count.
bool take_index(std::string_view& word) {
    take_any(word, "-");
    const std::string_view rest = word;
    const std::string_view digits = rest.substr(0, take_digits(word));
    return digits.size() <= 9 && digits.find_first_not_of('0') != std::string_view::npos;
}

}  // namespace

bool is_number(std::string_view word) {
    take_any(word, "+-");
    std::size_t digits = take_digits(word);
    if (take_any(word, ".")) {
        digits += take_digits(word);
    }
    if (digits != 0 && take_any(word, "eE")) {
        take_any(word, "+-");
        const std::size_t exponent = take_digits(word);
        return exponent >= 1 && exponent <= 4 && word.empty();
    }
    return digits != 0 && word.empty();
}

bool is_nan_or_inf(std::string_view word) {
    const std::size_t sign = word.find_first_not_of("+-");
    if (sign > 1) {
        return false;
    }
    std::string letters(word.substr(sign, 3));
    std::transform(letters.begin(), letters.end(), letters.begin(),
                   [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c + 32) : c; });
    return letters == "nan" || letters == "inf";
}

bool is_corner(std::string_view word) {
    bool good = take_index(word);
    for (int slashes = 0; good && slashes < 2 && word.starts_with('/'); ++slashes) {
        word.remove_prefix(1);
        good = word.empty() || word.front() == '/' || take_index(word);
    }
    return good && word.empty();
}

bool is_keyword(std::string_view word) {
    return !is_digit(word.front()) && std::all_of(word.begin(), word.end(), [](char c) {
        return is_letter(c) || is_digit(c);
    });
}

bool is_passed_over(std::string_view keyword) {
    static const std::set<std::string_view> keywords = {
        "bevel", "bmat", "bsp",       "bzp",   "c_interp", "call",       "cdc",      "cdp",
        "con",   "csh",  "cstype",    "ctech", "curv",     "curv2",      "d_interp", "deg",
        "end",   "g",    "hole",      "l",     "lod",      "maplib",     "mg",       "o",
        "p",     "parm", "res",       "s",     "scrv",     "shadow_obj", "sp",       "stech",
        "step",  "surf", "trace_obj", "trim",  "usemap",   "vp",         "vw"};
    return keywords.contains(keyword);
}

}  // namespace glint
