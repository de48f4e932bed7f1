// Rows of numbers under a header line, from a stream.
#pragma once

#include "framework/math/error.hpp"

#include <charconv>
#include <istream>
#include <string>
#include <string_view>
#include <vector>

namespace glint {

inline std::vector<std::string> split_csv(std::string_view line) {
    if (line.ends_with('\r')) {
        line.remove_suffix(1);
    }
    std::vector<std::string> cells{""};
    for (const char c : line) {
        if (c == ',') {
            cells.emplace_back();
        } else if (c != ' ' && c != '\t') {
            cells.back() += c;
        }
    }
    return cells;
}

// Reads the named columns, in their order, of one row after the other; other columns are passed
// over. Error "standard input:LINE: ..." where a column or a number is missing.
class CsvReader {
  public:
    CsvReader(std::istream& in, const std::vector<std::string>& columns)
        : in_(in), columns_(columns) {
        std::string line;
        std::getline(in_, line);
        const std::vector<std::string> header = split_csv(line);
        for (const std::string& column : columns) {
            std::size_t at = 0;
            while (at < header.size() && header[at] != column) {
                ++at;
            }
            if (at == header.size()) {
                throw Error("standard input:1: the header lacks the column " + column);
            }
            place_.push_back(at);
        }
    }

    bool next(std::vector<double>& values) {
        std::string text;
        do {
            if (!std::getline(in_, text)) {
                return false;
            }
            ++line_;
        } while (text.empty() || text == "\r");
        const std::vector<std::string> cells = split_csv(text);
        values.clear();
        for (std::size_t i = 0; i < place_.size(); ++i) {
            values.push_back(number(place_[i] < cells.size() ? cells[place_[i]] : "", columns_[i]));
        }
        return true;
    }

  private:
    double number(const std::string& cell, const std::string& column) const {
        double value = 0;
        const char* begin = cell.data() + (cell.starts_with('+') ? 1 : 0);
        const char* end = cell.data() + cell.size();
        const auto [stop, error] = std::from_chars(begin, end, value);
        if (error == std::errc::result_out_of_range || error != std::errc() || stop != end) {
            throw Error("standard input:" + std::to_string(line_) + ": column " + column +
                        " needs a number, not '" + cell + "'");
        }
        return value;
    }

    std::istream& in_;
    std::vector<std::string> columns_;
    std::vector<std::size_t> place_;
    int line_ = 1;
};

}  // namespace glint
