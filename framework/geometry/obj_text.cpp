#include "framework/geometry/obj_text.hpp"

#include "framework/math/error.hpp"

#include <algorithm>
#include <fstream>

namespace glint {
namespace {

constexpr std::uintmax_t max_bytes = std::uintmax_t{1} << 31;

bool is_space(char c) {
    return c == ' ' || c == '\t';
}

bool is_line_end(char c) {
    return c == '\n' || c == '\r';
}

// How many characters it is until the first that is asked for, or to the end.
template <class Predicate>
std::size_t length_until(std::string_view text, Predicate is_end) {
    return static_cast<std::size_t>(std::find_if(text.begin(), text.end(), is_end) - text.begin());
}

template <class Predicate>
std::size_t length_of(std::string_view text, Predicate is_part) {
    return length_until(text, [=](char c) { return !is_part(c); });
}

std::string_view trimmed(std::string_view text) {
    text.remove_prefix(length_of(text, is_space));
    while (!text.empty() && is_space(text.back())) {
        text.remove_suffix(1);
    }
    return text;
}

// For the terminal: no control characters, which could also break the line.
std::string printable(std::string_view text) {
    std::string result(text);
    std::replace_if(
        result.begin(), result.end(),
        [](char c) { return static_cast<unsigned char>(c) < 0x20 || c == 0x7f; }, '?');
    return result;
}

[[noreturn]] void fail(const std::filesystem::path& path, const char* what) {
    throw Error(in_file(path) + what);
}

}  // namespace

Statements::Statements(std::string_view text) : rest_(text) {
    if (rest_.starts_with("\xEF\xBB\xBF")) {  // UTF-8's byte order mark
        rest_.remove_prefix(3);
    }
}

std::string_view Statements::take_line() {
    const std::size_t end = length_until(rest_, is_line_end);
    const std::string_view line = rest_.substr(0, end);
    rest_.remove_prefix(end);
    rest_.remove_prefix(rest_.starts_with("\r\n") ? 2 : std::min<std::size_t>(1, rest_.size()));
    ++line_;
    return line;
}

std::optional<Statement> Statements::next() {
    while (!rest_.empty()) {
        std::string_view text = trimmed(take_line());
        const std::size_t first_line = line_;
        if (text.empty() || text.front() == '#') {
            continue;
        }
        if (text.ends_with('\\')) {
            joined_ = text;
            while (joined_.ends_with('\\')) {
                joined_.back() = ' ';
                joined_ += trimmed(take_line());
            }
            text = trimmed(joined_);
            if (text.empty()) {
                continue;
            }
        }
        const std::size_t end = length_until(text, is_space);
        return Statement{text.substr(0, end), trimmed(text.substr(end)), first_line};
    }
    return std::nullopt;
}

std::string_view take_word(std::string_view& arguments) {
    arguments.remove_prefix(length_of(arguments, is_space));
    if (arguments.starts_with('#')) {
        arguments = {};
    }
    const std::size_t end = length_until(arguments, is_space);
    const std::string_view word = arguments.substr(0, end);
    arguments.remove_prefix(end);
    return word;
}

std::string shown(std::string_view word) {
    constexpr std::size_t longest = 40;
    const bool cut = word.size() > longest;
    return '`' + printable(word.substr(0, longest)) + (cut ? "...`" : "`");
}

std::string read_obj_text(const std::filesystem::path& path) {
    std::error_code ignored;
    if (!std::filesystem::exists(path, ignored)) {
        fail(path, "no such file");
    }
    if (std::filesystem::is_directory(path, ignored)) {
        fail(path, "is a folder, not a file");
    }
    if (!is_file(path)) {
        fail(path, "is not a file");
    }
    const std::uintmax_t size = std::filesystem::file_size(path, ignored);
    if (size > max_bytes) {
        fail(path, "is larger than 2 GiB");
    }
    std::ifstream file(path, std::ios::binary);
    std::string text(size, '\0');
    if (!file.read(text.data(), static_cast<std::streamsize>(size))) {
        fail(path, "cannot be read");
    }
    check_text(text, path);
    return text;
}

void check_text(std::string_view text, const std::filesystem::path& path) {
    if (text.empty()) {
        fail(path, "is empty");
    }
    if (text.find('\0') != std::string_view::npos) {
        fail(path, "is a binary file, not text");
    }
}

std::string in_file(const std::filesystem::path& path) {
    return printable(path.string()) + ": ";
}

std::string at_line(const std::filesystem::path& path, std::size_t line) {
    return printable(path.string()) + ':' + std::to_string(line) + ": ";
}

bool is_file(const std::filesystem::path& path) {
    std::error_code ignored;
    return std::filesystem::is_regular_file(path, ignored);
}

}  // namespace glint
