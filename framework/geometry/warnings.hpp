// Warnings about a file, so many as a person would read.
#pragma once

#include <cstddef>
#include <string>
#include <utility>
#include <vector>

namespace glint {

class Warnings {
  public:
    void add(std::string line) {
        if (lines_.size() < most) {
            lines_.push_back(std::move(line));
        } else {
            ++further_;
        }
    }
    std::vector<std::string> take() {
        if (further_ != 0) {
            lines_.push_back("and " + std::to_string(further_) + " more warnings");
        }
        return std::move(lines_);
    }

  private:
    static constexpr std::size_t most = 50;
    std::vector<std::string> lines_;
    std::size_t further_ = 0;
};

// The same complaint about many lines makes one warning.
struct Tally {
    std::size_t count = 0;
    std::size_t first_line = 0;
    void add(std::size_t line) { first_line = count++ == 0 ? line : first_line; }
};

}  // namespace glint
