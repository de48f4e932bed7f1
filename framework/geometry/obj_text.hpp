// What OBJ and MTL have in common: lines of a keyword and arguments. For the reader alone.
#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

namespace glint {

struct Statement {
    std::string_view keyword;    // "v", "usemtl"
    std::string_view arguments;  // without space at the ends
    std::size_t line = 0;        // the first of its lines, from 1
};

// Cuts a text into statements. Lines end with LF, CR or both; a backslash at the end of a line
// goes on with the next; empty lines and comments are passed over.
class Statements {
  public:
    explicit Statements(std::string_view text);

    // Valid until the next call; nothing at the end of the text.
    std::optional<Statement> next();

  private:
    std::string_view take_line();

    std::string_view rest_;
    std::string joined_;  // a statement of several lines
    std::size_t line_ = 0;
};

// The next word of arguments, which it is cut off from; empty at the end or at a comment.
std::string_view take_word(std::string_view& arguments);

// A word of a file as a message shows it: `word`, cut if long, harmless for a terminal.
std::string shown(std::string_view word);

// All of a text file; an Error if it cannot be read, is larger than 2 GiB, empty or binary.
std::string read_obj_text(const std::filesystem::path& path);

// An Error if the text is empty or has a zero byte.
void check_text(std::string_view text, const std::filesystem::path& path);

// "file.obj: " and "file.obj:17: "
std::string in_file(const std::filesystem::path& path);
std::string at_line(const std::filesystem::path& path, std::size_t line);

bool is_file(const std::filesystem::path& path);

}  // namespace glint
