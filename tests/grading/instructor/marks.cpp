#include "tests/grading/instructor/marks.hpp"

#include "framework/math/error.hpp"

#include <algorithm>
#include <optional>
#include <regex>

namespace glint::grading {
namespace {

enum class Mark { none, solution, instructor, handout, end, misspelt };

struct Line {
    Mark mark;
    std::string task;  // of a solution
};

Line read_line(const std::string& text) {
    static const std::regex solution(R"(\s*// SOLUTION (\d\d\.\d))");
    static const std::regex other(R"(\s*(//|#) (INSTRUCTOR|HANDOUT|END))");
    static const std::regex almost(R"(.*(//|#)\s*((SOLUTION|INSTRUCTOR|HANDOUT)\b.*|END\s*))");
    std::smatch match;
    if (std::regex_match(text, match, solution)) {
        return {Mark::solution, match[1]};
    }
    if (std::regex_match(text, match, other)) {
        return {match[2] == "INSTRUCTOR" ? Mark::instructor
                : match[2] == "HANDOUT"  ? Mark::handout
                                         : Mark::end,
                {}};
    }
    return {std::regex_match(text, almost) ? Mark::misspelt : Mark::none, {}};
}

// The line without its first "// "; nothing where it is no comment.
std::optional<std::string> uncommented(const std::string& line) {
    const std::size_t at = line.find_first_not_of(' ');
    if (at == std::string::npos || line.compare(at, 3, "// ") != 0) {
        return std::nullopt;
    }
    return line.substr(0, at) + line.substr(at + 3);
}

class Reader {
  public:
    explicit Reader(std::string file) : file_(std::move(file)) {}

    void take(const std::string& text) {
        ++number_;
        const Line line = read_line(text);
        switch (line.mark) {
            case Mark::none:
                add(text);
                break;
            case Mark::solution:
            case Mark::instructor:
                open(line);
                break;
            case Mark::handout:
                turn();
                break;
            case Mark::end:
                close();
                break;
            case Mark::misspelt:
                fail("a mark stands alone on its line, as // SOLUTION 09.1");
        }
    }

    std::vector<Region> finish() {
        if (inside_) {
            number_ = opened_;
            fail("this mark is not closed by END");
        }
        return std::move(regions_);
    }

  private:
    [[noreturn]] std::string fail(const std::string& what) const {
        throw Error(file_ + ":" + std::to_string(number_) + ": " + what);
    }
    void add(const std::string& text) {
        if (regions_.empty() || (regions_.back().marked && !inside_)) {
            regions_.emplace_back();
        }
        Region& region = regions_.back();
        if (in_skeleton_) {
            const auto line = uncommented(text);
            region.skeleton.push_back(line ? *line : fail("a skeleton's line starts with \"// \""));
            return;
        }
        region.solution.push_back(text);
        if (!inside_) {
            region.skeleton.push_back(text);
        }
    }
    void open(const Line& line) {
        if (inside_) {
            fail("a mark within the one of line " + std::to_string(opened_));
        }
        regions_.push_back({line.task, {}, {}, true});
        inside_ = true;
        opened_ = number_;
    }
    void turn() {
        if (!inside_ || in_skeleton_ || regions_.back().task.empty()) {
            fail("HANDOUT without SOLUTION before it");
        }
        in_skeleton_ = true;
    }
    void close() {
        if (!inside_) {
            fail("END without SOLUTION or INSTRUCTOR before it");
        }
        if (!in_skeleton_ && !regions_.back().task.empty()) {
            fail("END without HANDOUT before it");
        }
        inside_ = in_skeleton_ = false;
    }

    std::string file_;
    std::vector<Region> regions_;
    int number_ = 0;
    int opened_ = 0;
    bool inside_ = false;
    bool in_skeleton_ = false;
};

void append(std::string& text, const Lines& lines) {
    for (const std::string& line : lines) {
        text += line + '\n';
    }
}

}  // namespace

std::vector<Region> read_marks(const std::string& file, std::string_view text) {
    Reader reader(file);
    while (!text.empty()) {
        const std::size_t end = std::min(text.find('\n'), text.size());
        reader.take(std::string(text.substr(0, end)));
        text.remove_prefix(std::min(end + 1, text.size()));
    }
    return reader.finish();
}

std::string handed_out(const std::vector<Region>& regions) {
    std::string text;
    for (const Region& region : regions) {
        append(text, region.skeleton);
    }
    return text;
}

std::string with_answer(const std::vector<Region>& regions, std::string_view task,
                        const Lines& answer) {
    std::string text;
    for (const Region& region : regions) {
        append(text, !task.empty() && region.task == task ? answer : region.solution);
    }
    return text;
}

}  // namespace glint::grading
