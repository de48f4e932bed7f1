#include "tests/grading/instructor/marks.hpp"

#include "framework/math/error.hpp"
#include "tests/grading/instructor/mutants.hpp"

#include <doctest/doctest.h>

namespace glint::grading {
namespace {

constexpr const char* source =
    "before\n"
    "  // SOLUTION 09.1\n"
    "  return n + 2;\n"
    "  // HANDOUT\n"
    "  // return 1;  // TODO 09.1\n"
    "  // // more\n"
    "  // END\n"
    "between\n"
    "# INSTRUCTOR\n"
    "hidden\n"
    "# END\n"
    "after\n";

std::string error_of(const std::string& text) {
    try {
        read_marks("a.hpp", text);
    } catch (const Error& e) {
        return e.what();
    }
    return "";
}

TEST_CASE("answers go, skeletons come, what is the instructor's goes") {
    CHECK(handed_out(read_marks("a.hpp", source)) ==
          "before\n  return 1;  // TODO 09.1\n  // more\nbetween\nafter\n");
}

TEST_CASE("the instructor's source loses its marks only") {
    const auto regions = read_marks("a.hpp", source);
    CHECK(with_answer(regions, "", {}) == "before\n  return n + 2;\nbetween\nhidden\nafter\n");
    CHECK(with_answer(regions, "09.1", {"x"}) == "before\nx\nbetween\nhidden\nafter\n");
    CHECK(with_answer(regions, "09.2", {"x"}) == with_answer(regions, "", {}));
}

TEST_CASE("a text without marks stays as it is, and so does an empty one") {
    const std::string text = "a\n\n  b // of SOLUTIONS\n// Ends here: END of it\n";
    CHECK(handed_out(read_marks("a.hpp", text)) == text);
    CHECK(handed_out(read_marks("a.hpp", "")).empty());
}

TEST_CASE("wrong marks are errors that name file and line") {
    const struct {
        const char *text, *error;
    } cases[] = {
        {"// SOLUTION 09.1\n// SOLUTION 09.2\n", "a.hpp:2: a mark within the one of line 1"},
        {"x\n// SOLUTION 09.1\n", "a.hpp:2: this mark is not closed by END"},
        {"// SOLUTION 09.1\n// HANDOUT\n", "a.hpp:1: this mark is not closed by END"},
        {"// INSTRUCTOR\n", "a.hpp:1: this mark is not closed by END"},
        {"// HANDOUT\n", "a.hpp:1: HANDOUT without SOLUTION before it"},
        {"// INSTRUCTOR\n// HANDOUT\n", "a.hpp:2: HANDOUT without SOLUTION before it"},
        {"// SOLUTION 09.1\n// HANDOUT\n// HANDOUT\n", "a.hpp:3: HANDOUT without"},
        {"// SOLUTION 09.1\n// INSTRUCTOR\n", "a.hpp:2: a mark within"},
        {"// END\n", "a.hpp:1: END without SOLUTION or INSTRUCTOR before it"},
        {"// SOLUTION 09.1\n// END\n", "a.hpp:2: END without HANDOUT before it"},
        {"// SOLUTION 09.1\n// HANDOUT\nreturn 1;\n// END\n", "a.hpp:3: a skeleton's line starts"},
        {"x = 1;  // SOLUTION 09.1\n", "a.hpp:1: a mark stands alone"},
        {"// SOLUTION\n", "a.hpp:1: a mark stands alone"},
        {"// SOLUTION 9.1\n", "a.hpp:1: a mark stands alone"},
        {"//SOLUTION 09.1\n", "a.hpp:1: a mark stands alone"},
        {"// HANDOUT 09.1\n", "a.hpp:1: a mark stands alone"},
        {"x;  // END\n", "a.hpp:1: a mark stands alone"},
        {"# SOLUTION 09.1\n", "a.hpp:1: a mark stands alone"},
    };
    for (const auto& c : cases) {
        CAPTURE(std::string(c.text));
        CAPTURE(error_of(c.text));
        CHECK(error_of(c.text).starts_with(c.error));
    }
}

TEST_CASE("mutants are read with their words") {
    const auto all = read_mutants("m", "// MUTANT 09.1 no 1/pi\n  a;\n  b;\n// MUTANT 09.2 x\n");
    REQUIRE(all.size() == 2);
    CHECK(all[0].task == "09.1");
    CHECK(all[0].words == "no 1/pi");
    CHECK(all[0].code == Lines{"  a;", "  b;"});
    CHECK(all[1].code.empty());
    CHECK_THROWS_AS(read_mutants("m", "a;\n"), Error);
}

}  // namespace
}  // namespace glint::grading
