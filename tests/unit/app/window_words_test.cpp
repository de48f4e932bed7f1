#include "framework/app/window_words.hpp"

#include <doctest/doctest.h>

namespace glint {
namespace {

Options some_options() {
    Options o;
    o.width = 640;
    o.height = 360;
    o.settings = {.lanes = 4, .threads = 3, .samples = 8};
    return o;
}

TEST_CASE("the status says how long a frame and a fragment took, and what drew them") {
    Statistics frame;
    frame.frame_ms = 2;
    frame.fragments_shaded = 100000;
    const Lines lines = status_lines(some_options(), frame, 0);
    REQUIRE(lines.size() == 3);
    CHECK(lines[0] == "2.00 ms, 20.0 ns a fragment, 640x360");
    CHECK(lines[1] == "tiles, 4 lanes, 3 threads, 8 samples");
    CHECK(lines[2] == "view shaded");
}

TEST_CASE("an empty frame has no time a fragment; scanline has one lane and thread") {
    Options o = some_options();
    o.settings.rasterizer = Rasterizer::scanline;
    o.settings.cull = Cull::back;
    o.view = ViewMode::overdraw;
    const Lines lines = status_lines(o, Statistics(), 0);
    CHECK(lines[0] == "0.00 ms, 640x360");
    CHECK(lines[1] == "scanline, 1 lane, 1 thread, 1 sample, culling");
    CHECK(lines[2] == "view overdraw");
}

TEST_CASE("the chosen parameter has its limits and its meaning") {
    Options o = some_options();
    o.parameters = {{"a", 0, 0, 1, "first"}, {"exponent", 12.5F, 0, 1000, "of the lobe"}};
    const Lines lines = status_lines(o, Statistics(), 1);
    REQUIRE(lines.size() == 5);
    CHECK(lines[3] == "[2/2] exponent = 12.5 (0..1000)");
    CHECK(lines[4] == "of the lobe");
}

TEST_CASE("a report is a table with columns under their heads") {
    PixelReport report;
    report.words = {"material clay"};
    report.readings = {{"N.L", 0.5, 0.25}, {"a long name", -1e-20, 1.0 / 3}};
    const Lines lines = report_lines(report);
    REQUIRE(lines.size() == 4);
    CHECK(lines[0] == "material clay");
    CHECK(lines[1] == "                    float        double difference");
    CHECK(lines[2] == "N.L                   0.5          0.25    2.5e-01");
    CHECK(lines[3] == "a long name        -1e-20     0.3333333   -3.3e-01");
}

TEST_CASE("where nothing is drawn there is no table") {
    PixelReport report;
    report.words = {"nothing is drawn here"};
    CHECK(report_lines(report) == Lines{"nothing is drawn here"});
}

TEST_CASE("a difference is told with its place and share") {
    CodeDifference d;
    CHECK(difference_line(d, "x.png") == "no difference from x.png");
    d.largest = 7;
    d.x = 3;
    d.y = 4;
    d.share = 0.125;
    CHECK(difference_line(d, "x.png") ==
          "against x.png: largest 7 of 255 codes at 3,4, 12.5 % of pixels differ");
}

TEST_CASE("the meanings of keys stand in one column") {
    const Lines lines = key_lines();
    CHECK(lines.size() > 10);
    const auto column = lines.front().find("orbit");
    for (const std::string& line : lines) {
        CHECK(line.at(column) != ' ');
        CHECK(line.at(column - 1) == ' ');
    }
}

}  // namespace
}  // namespace glint
