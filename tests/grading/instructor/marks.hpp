// Marks in a source: which lines are the answer, which the skeleton, which no student sees.
//
//     // SOLUTION 09.1           // INSTRUCTOR
//     the answer                 what only the instructor's tree has
//     // HANDOUT                 // END
//     // the skeleton
//     // END
//
// A mark stands alone on its line, after // or #. A skeleton's lines are comments here; handing out
// strips one leading "// " of each.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace glint::grading {

// Lines of a source as they stand, without their ends.
using Lines = std::vector<std::string>;

struct Region {
    std::string task;  // "09.1"; empty where only the instructor sees it, or everyone
    Lines solution;    // what the instructor's tree compiles
    Lines skeleton;    // what students get instead
    bool marked = false;
};

// The source as unmarked and marked regions in turn. Nested, unclosed and stray marks are an Error
// that names file and line.
std::vector<Region> read_marks(const std::string& file, std::string_view text);

// What students get of a source.
std::string handed_out(const std::vector<Region>& regions);

// The instructor's source without marks; with other lines for the answer of one task, where one is
// named.
std::string with_answer(const std::vector<Region>& regions, std::string_view task,
                        const Lines& answer);

}  // namespace glint::grading
