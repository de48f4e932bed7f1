// Words that strangers chose, made fit for terminals and reports.
#pragma once

#include <string>
#include <string_view>

namespace glint::grading {

// Valid UTF-8 without NUL.
bool is_plain_text(std::string_view text);

// Printable: control characters but line ends and tabs, and what is not UTF-8, become '?'; text
// beyond the limit is cut.
std::string printable(std::string_view text, std::size_t limit);

// One word for a shell, whatever is in it.
std::string shell_word(std::string_view text);

}  // namespace glint::grading
