#include "framework/app/programs/coverage_io.hpp"

#include "framework/math/error.hpp"

#include <doctest/doctest.h>

#include <sstream>

using namespace std::string_literals;

namespace glint {
namespace {

std::vector<CoverageCase> read_all(const std::string& text) {
    std::istringstream in(text);
    CoverageInput state;
    std::vector<CoverageCase> cases;
    while (auto c = read_case(in, state)) {
        cases.push_back(std::move(*c));
    }
    return cases;
}

CoverageCase read_one(const std::string& text) {
    const std::vector<CoverageCase> cases = read_all(text);
    REQUIRE(cases.size() == 1);
    return cases[0];
}

glm::ivec2 first_vertex(const std::string& x, const std::string& y) {
    return read_one("T a 8 8 " + x + " " + y + " 1 2 3 4").triangles[0][0];
}

TEST_CASE("a line is a case, its positions in 1/256 pixel") {
    const CoverageCase c = read_one("T first 640 480 0.5 1 -2.25 3 16384 -16384\n");
    CHECK(c.id == "first");
    CHECK(c.width == 640);
    CHECK(c.height == 480);
    REQUIRE(c.triangles.size() == 1);
    CHECK(c.triangles[0][0] == glm::ivec2(128, 256));
    CHECK(c.triangles[0][1] == glm::ivec2(-576, 768));
    CHECK(c.triangles[0][2] == glm::ivec2(4194304, -4194304));
}

TEST_CASE("positions are rounded to nearest, ties to even, from all digits") {
    CHECK(first_vertex("0.001953125", "0.005859375") == glm::ivec2(0, 2));  // 0.5, 1.5
    CHECK(first_vertex("-0.001953125", "-0.005859375") == glm::ivec2(0, -2));
    CHECK(first_vertex("0.001953126", "0.005859374") == glm::ivec2(1, 1));
    // 16383.998046875 is a tie; the next is 2^-30 above it, more than a float can tell.
    CHECK(first_vertex("16383.998046875", "16383.998046875931") == glm::ivec2(4194304, 4194304));
    CHECK(first_vertex("16383.994140625", "16383.994140625931") == glm::ivec2(4194302, 4194303));
}

TEST_CASE("fewer bits snap to a coarser grid, ties to even") {
    const auto snapped = [](int bits, const char* words) {
        std::istringstream in(std::string("T a 8 8 ") + words);
        CoverageInput state{.bits = bits, .line = 0, .begun = {}, .text = {}};
        const auto t = read_case(in, state)->triangles[0];
        return std::array{t[0].x, t[0].y, t[1].x, t[1].y, t[2].x, t[2].y};
    };
    using Six = std::array<int, 6>;
    CHECK(snapped(0, "0.5 1.5 -2.5 0.51 3 -16384") == Six{0, 512, -512, 256, 768, -4194304});
    CHECK(snapped(4, "0.03125 0.09375 -0.04 0.5 3 16384") == Six{0, 32, -16, 128, 768, 4194304});
    CHECK(snapped(8, "0.001953125 0.01 -0.01 0.5 3 7") == Six{0, 3, -3, 128, 768, 1792});
}

TEST_CASE("numbers may have signs and exponents") {
    CHECK(first_vertex("1e2", "+2.5E-1") == glm::ivec2(25600, 64));
    CHECK(first_vertex("-.5", "5.") == glm::ivec2(-128, 1280));
    CHECK(first_vertex("-0", "1e-400") == glm::ivec2(0, 0));
    CHECK(first_vertex("000012", "0.0000000000000000000000000000000000001") == glm::ivec2(3072, 0));
}

TEST_CASE("consecutive lines with one id are a mesh, later ones a new case") {
    const auto cases = read_all(
        "T a 8 8 0 0 1 0 0 1\n"
        "T b 9 9 0 0 1 0 0 1\n"
        "T b 9 9 1 0 1 1 0 1\n"
        "T a 7 7 0 0 1 0 0 1\n");
    REQUIRE(cases.size() == 3);
    CHECK(cases[0].triangles.size() == 1);
    CHECK(cases[1].triangles.size() == 2);
    CHECK(cases[1].triangles[1][0] == glm::ivec2(256, 0));
    CHECK(cases[2].id == "a");
    CHECK(cases[2].width == 7);
}

TEST_CASE("blank lines, comments, tabs and line ends of all systems are passed over") {
    const auto cases = read_all(
        "# triangles\r\n"
        "\r\n"
        "T a 8 8 0 0 1 0 0 1\r\n"
        "   \t \n"
        "  # within a mesh\n"
        "T\ta\t8\t8  1 0 1 1\t0 1   \r\n"
        "#T c 8 8 0 0 1 0 0 1");
    REQUIRE(cases.size() == 1);
    CHECK(cases[0].triangles.size() == 2);
    CHECK(read_all("").empty());
    CHECK(read_all("\n\n#\n").empty());
}

TEST_CASE("ids are any words") {
    CHECK(read_one("T T 8 8 0 0 1 0 0 1").id == "T");
    CHECK(read_one("T #7/\xC3\xA4,\"x\" 8 8 0 0 1 0 0 1").id == "#7/\xC3\xA4,\"x\"");
    const std::string longest(60000, 'i');
    CHECK(read_one("T " + longest + " 8 8 0 0 1 0 0 1").id == longest);
}

TEST_CASE("a case is complete as soon as another begins") {
    std::istringstream in(
        "T a 8 8 0 0 1 0 0 1\n"
        "T b 8 8 0 0 1 0 0 1\n"
        "rest\n");
    CoverageInput state;
    CHECK(read_case(in, state)->id == "a");
    std::string rest;
    std::getline(in, rest);
    CHECK(rest == "rest");
}

// ---- errors -----------------------------------------------------------------------------------

std::string complaint(const std::string& text) {
    try {
        read_all(text);
    } catch (const Error& e) {
        return e.what();
    }
    return "none";
}

std::string complaint_about_line(const std::string& words) {
    return complaint("# first\nT a 8 8 0 0 1 0 0 1\n" + words + "\nT b 8 8 0 0 1 0 0 1\n");
}

TEST_CASE("a line of another form is told by its number") {
    CHECK(complaint_about_line("T b 8 8 0 0 1 0 0") ==
          "standard input:3: expected T id width height x0 y0 x1 y1 x2 y2, found 9 words, the "
          "first \"T\"");
    CHECK(complaint_about_line("T b 8 8 0 0 1 0 0 1 7").find("found 11 words") !=
          std::string::npos);
    CHECK(complaint_about_line("t b 8 8 0 0 1 0 0 1").find("the first \"t\"") != std::string::npos);
    CHECK(complaint_about_line("T").find(":3: expected") != std::string::npos);
}

TEST_CASE("sizes are whole numbers from 1 to 16384") {
    CHECK(complaint_about_line("T b 0 8 0 0 1 0 0 1") ==
          "standard input:3: width is \"0\", not a whole number from 1 to 16384");
    CHECK(complaint_about_line("T b 8 16385 0 0 1 0 0 1") ==
          "standard input:3: height is \"16385\", not a whole number from 1 to 16384");
    for (const char* bad : {"-1", "8.5", "1e2", "x", "99999999999999999999", "8x", "0x8"}) {
        CAPTURE(bad);
        CHECK(complaint_about_line("T b " + std::string(bad) + " 8 0 0 1 0 0 1")
                  .find(":3: width is \"") != std::string::npos);
    }
    CHECK(complaint("T b 16384 1 0 0 1 0 0 1") == "none");
}

TEST_CASE("positions are finite numbers within the guard band") {
    CHECK(complaint_about_line("T b 8 8 0 0 1 nan 0 1") ==
          "standard input:3: y1 is \"nan\", not a number from -16384 to 16384");
    for (const char* bad : {"inf", "-inf", "NAN", "1e400", "-1e400", "16384.001", "-16385", "0x1p3",
                            "1e", "1.5f", "1,5", "--1", "+-1", ".", "e5", "1.2.3"}) {
        CAPTURE(bad);
        CHECK(complaint_about_line("T b 8 8 0 0 1 0 0 " + std::string(bad)).find(":3: y2 is \"") !=
              std::string::npos);
    }
}

TEST_CASE("a mesh keeps its size") {
    CHECK(complaint("T a 8 8 0 0 1 0 0 1\nT a 8 9 0 0 1 0 0 1\n") ==
          "standard input:2: mesh \"a\" began with 8 x 8 pixels, and cannot go on with 8 x 9");
}

TEST_CASE("messages stay one short line, lines end somewhere") {
    const std::string loud =
        complaint_about_line("T b 8 8 0 0 1 0 0 \x1b[2J" + std::string(99, '9'));
    CHECK(loud.find('\x1b') == std::string::npos);
    CHECK(loud.size() < 150);
    CHECK(complaint(std::string(70000, '1')) ==
          "standard input:1: the line is longer than 65536 characters");
    CHECK(complaint("#" + std::string(65535, '-') + "\n") == "none");
    CHECK(complaint("#" + std::string(65536, '-') + "\n") != "none");
    const std::string binary = "T a\0b 8"s;
    CHECK(complaint(binary).find(":1: expected") != std::string::npos);
    CHECK(complaint(std::string(8, '\0')).find("\"????????\"") != std::string::npos);
}

// ---- writing ----------------------------------------------------------------------------------

std::string written(int triangles, std::vector<CoverageRun> runs) {
    CoverageCase c{"name", 8, 8, {}};
    c.triangles.resize(static_cast<std::size_t>(triangles));
    std::ostringstream out;
    write_case(out, c, std::move(runs));
    return out.str();
}

TEST_CASE("runs are written in order, pieces joined") {
    CHECK(written(1, {}) == "T name\n");
    CHECK(written(1, {{0, 2, 4, 8}, {0, 1, 0, 3}, {0, 2, 0, 4}}) == "T name\n1 0 3\n2 0 8\n");
    CHECK(written(1, {{0, 1, 5, 6}, {0, 1, 0, 3}}) == "T name\n1 0 3\n1 5 6\n");
}

TEST_CASE("runs of a mesh name their triangle, and only its own pieces are joined") {
    CHECK(written(2, {{1, 1, 3, 8}, {0, 1, 0, 2}, {0, 1, 2, 3}, {1, 0, 0, 1}}) ==
          "T name\n0 0 1 1\n1 0 3 0\n1 3 8 1\n");
    CHECK(written(2, {{1, 0, 0, 2}, {0, 0, 0, 2}}) == "T name\n0 0 2 0\n0 0 2 1\n");
}

TEST_CASE("a pixel that is covered twice is not hidden") {
    CHECK(written(1, {{0, 0, 0, 4}, {0, 0, 3, 6}}) == "T name\n0 0 4\n0 3 6\n");
}

TEST_CASE("a stream that takes no more is an error") {
    std::ostringstream out;
    out.setstate(std::ios::badbit);
    CHECK_THROWS_WITH_AS(write_case(out, {"a", 8, 8, {}}, {}), "cannot write to standard output",
                         Error);
}

}  // namespace
}  // namespace glint
