#include "framework/app/statistics.hpp"

#include "framework/image/file.hpp"
#include "tests/temporary.hpp"
#include "tests/unit/app/small_lesson.hpp"

#include <doctest/doctest.h>
#include <nlohmann/json.hpp>

namespace glint {
namespace {

using nlohmann::json;

Drawing five_frames() {
    Drawing d;
    for (const double ms : {7.0, 3.0, 5.0, 11.0, 4.0}) {
        Statistics s;
        s.frame_ms = ms;
        s.geometry_ms = ms / 2;
        s.visibility_ms = ms / 4;
        s.shading_ms = ms / 8;
        s.output_ms = ms / 16;
        s.fragments_shaded = 1234567;
        s.triangles_in = 30;
        s.triangles_visible = 20;
        s.triangles_not_finite = 1;
        s.tiles_empty = 6;
        d.frames.push_back(s);
    }
    return d;
}

json written(const Options& options, const Drawing& drawing) {
    const TemporaryFolder folder;
    Options o = options;
    o.stats = (folder / "s.json").string();
    write_statistics(small_lesson(), o, drawing);
    const auto bytes = read_file(o.stats);
    return json::parse(std::string(reinterpret_cast<const char*>(bytes.data()), bytes.size()));
}

TEST_CASE("the JSON has least and median times, and the counts") {
    const json s = written(small_options(), five_frames());
    CHECK(s["frames"] == 5);
    CHECK(s["frame_ms_min"] == 3.0);
    CHECK(s["frame_ms_median"] == 5.0);
    CHECK(s["geometry_ms_min"] == 1.5);
    CHECK(s["visibility_ms_median"] == 1.25);
    CHECK(s["shading_ms_min"] == 0.375);
    CHECK(s["output_ms_median"] == 0.3125);
    CHECK(s["fragments_shaded"] == 1234567);
    CHECK(s["triangles_in"] == 30);
    CHECK(s["triangles_visible"] == 20);
    CHECK(s["triangles_not_finite"] == 1);
    CHECK(s["tiles_empty"] == 6);
}

TEST_CASE("what is left out of a frame is counted") {
    Options o = small_options();
    o.width = 640;  // 10 x 2 tiles; the ball and the wall are in the middle
    o.height = 128;
    o.settings.cull = Cull::back;
    o.lights = {{{0, 0, 1}, Rgb<float>(1.0F)}, {{0, 1, 0}, Rgb<float>(0.0F)}};
    o.point_lights = {{{0, 0, 1}, Rgb<float>(0.0F)}};
    const Scene scene = make_scene(small_lesson(), o);
    CHECK(scene.lighting.directional.size() == 1);
    CHECK(scene.lighting.point.empty());
    const Statistics s = draw(small_lesson(), o, scene).frames.front();
    CHECK(s.tiles_empty == 16);
    CHECK(s.triangles_visible > 0);
    CHECK(s.triangles_visible <= s.triangles_in / 2 + 8);  // half of the ball looks away
    CHECK(s.fragments_shaded < 4 * 64 * 64);
}

TEST_CASE("the JSON says what drew it") {
    Options o = small_options();
    o.settings = {.lanes = 4, .threads = 3, .samples = 8};
    const json tiles = written(o, five_frames());
    CHECK(tiles["lesson"] == "00_small");
    CHECK(tiles["title"] == "A ball before a wall");
    CHECK(tiles["rasterizer"] == "tiles");
    CHECK(tiles["lanes"] == 4);
    CHECK(tiles["threads"] == 3);
    CHECK(tiles["samples"] == 8);
    CHECK(tiles["instruction_set"] == instruction_set);
    o.settings.rasterizer = Rasterizer::scanline;
    const json scanline = written(o, five_frames());
    CHECK(scanline["rasterizer"] == "scanline");
    CHECK(scanline["lanes"] == 1);
    CHECK(scanline["threads"] == 1);
    o.view = ViewMode::depth;
    CHECK(written(o, five_frames())["samples"] == 1);
}

TEST_CASE("the summary is one line for people") {
    const std::string line = summary(small_lesson(), small_options(), five_frames());
    CHECK(line.find("00_small") != std::string::npos);
    CHECK(line.find("1,234,567 fragments") != std::string::npos);
    CHECK(line.find("2.4 ns") != std::string::npos);  // the fastest frame: 3 ms
    CHECK(line.find("3.0 ms") != std::string::npos);
    CHECK(line.find("a.png") != std::string::npos);
    CHECK(line.find('\n') == std::string::npos);
    Drawing nothing = five_frames();
    for (Statistics& s : nothing.frames) {
        s.fragments_shaded = 0;
    }
    const std::string empty = summary(small_lesson(), small_options(), nothing);
    CHECK(empty.find("inf") == std::string::npos);
    CHECK(empty.find("nan") == std::string::npos);
}

}  // namespace
}  // namespace glint
