#include "framework/app/programs/coverage_io.hpp"

#include "framework/math/error.hpp"
#include "framework/math/fixed.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdlib>
#include <istream>
#include <ostream>
#include <string_view>
#include <tuple>
#include <utility>

namespace glint {
namespace {

constexpr int largest_size = 16384;
constexpr std::size_t longest_line = 65536;  // memory stays bounded whatever comes

// ---- lines to words ---------------------------------------------------------------------------

[[noreturn]] void fail(const CoverageInput& state, const std::string& what) {
    throw Error("standard input:" + std::to_string(state.line) + ": " + what);
}

// A word of the user's, fit for a message of one line.
std::string in_quotes(std::string_view word) {
    constexpr std::size_t longest = 40;
    std::string text(word.substr(0, longest));
    std::replace_if(
        text.begin(), text.end(),
        [](char c) { return static_cast<unsigned char>(c) < ' ' || c == '\x7f'; }, '?');
    return '"' + text + (word.size() > longest ? "...\"" : "\"");
}

bool next_line(std::istream& in, CoverageInput& state, std::string_view& line) {
    state.text.resize(longest_line + 1);  // and an end
    in.getline(state.text.data(), static_cast<std::streamsize>(state.text.size()));
    const auto taken = static_cast<std::size_t>(in.gcount());
    if (in.bad()) {
        throw Error("standard input: cannot be read");
    }
    if (in.fail() && taken == 0) {
        return false;
    }
    ++state.line;
    if (in.fail()) {
        fail(state, "the line is longer than " + std::to_string(longest_line) + " characters");
    }
    line = std::string_view(state.text).substr(0, in.eof() ? taken : taken - 1);
    return true;
}

std::vector<std::string_view> split(std::string_view line) {
    constexpr std::string_view blanks = " \t\r\v\f";
    std::vector<std::string_view> words;
    for (auto begin = line.find_first_not_of(blanks); begin != std::string_view::npos;) {
        const auto end = std::min(line.find_first_of(blanks, begin), line.size());
        words.push_back(line.substr(begin, end - begin));
        begin = line.find_first_not_of(blanks, end);
    }
    return words;
}

// ---- words to a triangle ----------------------------------------------------------------------

int to_size(const CoverageInput& state, const char* name, std::string_view word) {
    int size = 0;
    const auto [rest, error] = std::from_chars(word.data(), word.data() + word.size(), size);
    if (error != std::errc() || rest != word.data() + word.size() || size < 1 ||
        size > largest_size) {
        fail(state, std::string(name) + " is " + in_quotes(word) +
                        ", not a whole number from 1 to " + std::to_string(largest_size));
    }
    return size;
}

int to_subpixels(const CoverageInput& state, const char* name, std::string_view word) {
    const std::string text(word);
    char* rest = nullptr;
    const double pixels = std::strtod(text.c_str(), &rest);
    const bool is_decimal = word.find_first_not_of("+-.0123456789eE") == std::string_view::npos;
    if (!is_decimal || rest != text.c_str() + text.size() || !(std::abs(pixels) <= guard_band)) {
        fail(state, std::string(name) + " is " + in_quotes(word) + ", not a number from -" +
                        std::to_string(guard_band) + " to " + std::to_string(guard_band));
    }
    const int steps = 1 << state.bits;
    return static_cast<int>(std::nearbyint(pixels * steps)) * (subpixel_one / steps);
}

// A line as a case of one triangle.
CoverageCase to_case(const CoverageInput& state, const std::vector<std::string_view>& words) {
    if (words[0] != "T" || words.size() != 10) {
        fail(state, "expected T id width height x0 y0 x1 y1 x2 y2, found " +
                        std::to_string(words.size()) + " words, the first " + in_quotes(words[0]));
    }
    constexpr const char* names[] = {"x0", "y0", "x1", "y1", "x2", "y2"};
    std::array<int, 6> v{};
    for (std::size_t i = 0; i < 6; ++i) {
        v[i] = to_subpixels(state, names[i], words[4 + i]);
    }
    return {std::string(words[1]),
            to_size(state, "width", words[2]),
            to_size(state, "height", words[3]),
            {{glm::ivec2(v[0], v[1]), glm::ivec2(v[2], v[3]), glm::ivec2(v[4], v[5])}}};
}

std::string size_of(const CoverageCase& c) {
    return std::to_string(c.width) + " x " + std::to_string(c.height);
}

void join(const CoverageInput& state, CoverageCase& mesh, const CoverageCase& part) {
    if (part.width != mesh.width || part.height != mesh.height) {
        fail(state, "mesh " + in_quotes(mesh.id) + " began with " + size_of(mesh) +
                        " pixels, and cannot go on with " + size_of(part));
    }
    mesh.triangles.push_back(part.triangles[0]);
}

// ---- runs to text -----------------------------------------------------------------------------

// Pieces that touch become one run. What overlaps stays, for it is worth seeing.
void join_pieces(std::vector<CoverageRun>& runs) {
    std::ranges::sort(runs, {}, [](const CoverageRun& run) {
        return std::tuple(run.triangle, run.y, run.x_begin);
    });
    std::size_t count = 0;
    for (const CoverageRun& run : runs) {
        CoverageRun* last = count > 0 ? &runs[count - 1] : nullptr;
        if (last != nullptr && last->triangle == run.triangle && last->y == run.y &&
            last->x_end == run.x_begin) {
            last->x_end = run.x_end;
        } else {
            runs[count++] = run;
        }
    }
    runs.resize(count);
}

void append(std::string& text, int number, char end) {
    std::array<char, 12> digits{};
    const auto [last, error] = std::to_chars(digits.begin(), digits.end(), number);
    text.append(digits.begin(), last).push_back(end);
}

}  // namespace

std::optional<CoverageCase> read_case(std::istream& in, CoverageInput& state) {
    for (std::string_view line; next_line(in, state, line);) {
        const std::vector<std::string_view> words = split(line);
        if (words.empty() || words[0].starts_with('#')) {
            continue;
        }
        CoverageCase next = to_case(state, words);
        if (!state.begun) {
            state.begun = std::move(next);
        } else if (state.begun->id == next.id) {
            join(state, *state.begun, next);
        } else {
            return std::exchange(state.begun, std::move(next));
        }
    }
    return std::exchange(state.begun, std::nullopt);
}

void write_case(std::ostream& out, const CoverageCase& c, std::vector<CoverageRun> runs) {
    join_pieces(runs);
    std::ranges::sort(runs, {}, [](const CoverageRun& run) {
        return std::tuple(run.y, run.x_begin, run.triangle);
    });
    std::string text = "T " + c.id + "\n";
    for (const CoverageRun& run : runs) {
        append(text, run.y, ' ');
        append(text, run.x_begin, ' ');
        append(text, run.x_end, c.triangles.size() > 1 ? ' ' : '\n');
        if (c.triangles.size() > 1) {
            append(text, run.triangle, '\n');
        }
    }
    if (!(out << text << std::flush)) {
        throw Error("cannot write to standard output");
    }
}

}  // namespace glint
