#include "framework/app/options.hpp"

#include "framework/math/dispatch.hpp"
#include "framework/math/error.hpp"
#include "tests/unit/refusal.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <functional>
#include <thread>

namespace glint {
namespace {

using Words = std::vector<std::string>;

const Parameters two_parameters{{"gain", 1.0F, 0.0F, 10.0F, "brightness"},
                                {"bend", -0.5F, -1.0F, 1.0F, "curvature"}};

Options parse(const Words& words, const Parameters& parameters = two_parameters) {
    std::vector<const char*> argv{"00_test"};
    for (const std::string& word : words) {
        argv.push_back(word.c_str());
    }
    return parse_options(static_cast<int>(argv.size()), argv.data(), "00_test", "A test",
                         parameters);
}

std::string refusal(const Words& words, const Parameters& parameters = two_parameters) {
    return glint::refusal([&] { parse(words, parameters); });
}

TEST_CASE("without words there are defaults") {
    const Options o = parse({});
    CHECK(o.width == 960);
    CHECK(o.height == 540);
    CHECK(o.settings.rasterizer == Rasterizer::tiles);
    CHECK(o.settings.lanes == max_lanes);
    CHECK(o.settings.threads ==
          std::clamp(static_cast<int>(std::thread::hardware_concurrency()), 1, 256));
    CHECK(o.settings.samples == 4);
    CHECK(!o.settings.sample_shading);
    CHECK(o.settings.cull == Cull::none);
    CHECK(o.view == ViewMode::shaded);
    CHECK(o.outs.empty());
    CHECK(o.lights.empty());
    CHECK(o.point_lights.empty());
    CHECK(!o.probe);
    CHECK(!o.window);
    CHECK(!o.kd);
    CHECK(!o.eye);
    CHECK(o.stats.empty());
    CHECK(o.compare.empty());
    CHECK(o.parameters["gain"] == 1.0F);
    CHECK(o.parameters["bend"] == -0.5F);
}

TEST_CASE("every option is read") {
    const struct {
        Words words;
        std::function<bool(const Options&)> arrived;
    } cases[] = {
        {{"--scene", "a b.obj"}, [](const Options& o) { return o.scene_file == "a b.obj"; }},
        {{"--kd", "0.1,0.2,1"}, [](const Options& o) { return o.kd == glm::vec3(0.1F, 0.2F, 1); }},
        {{"--ks", "0,0.5,1"}, [](const Options& o) { return o.ks == glm::vec3(0, 0.5F, 1); }},
        {{"--ns", "80"}, [](const Options& o) { return o.ns == 80.0F; }},
        {{"--ns", "0"}, [](const Options& o) { return o.ns == 0.0F; }},
        {{"--size", "1x16384"}, [](const Options& o) { return o.width == 1 && o.height == 16384; }},
        {{"--eye", "-1,2e1,-.5"},
         [](const Options& o) { return o.eye == glm::vec3(-1, 20, -0.5F); }},
        {{"--eye=-1,2,3"}, [](const Options& o) { return o.eye == glm::vec3(-1, 2, 3); }},
        {{"--target", "1,2,3"}, [](const Options& o) { return o.target == glm::vec3(1, 2, 3); }},
        {{"--up", "0,0,1"}, [](const Options& o) { return o.up == glm::vec3(0, 0, 1); }},
        {{"--fov", "30.5"}, [](const Options& o) { return o.fov == 30.5F; }},
        {{"--near", "0.5"}, [](const Options& o) { return o.near == 0.5F; }},
        {{"--far", "5"}, [](const Options& o) { return o.far == 5.0F; }},
        {{"--near", "1", "--far", "2"},
         [](const Options& o) { return o.near == 1.0F && o.far == 2.0F; }},
        {{"--light", "0,3,4:1,2,3", "--light", "1,0,0:0,0,0"},
         [](const Options& o) {
             return o.lights.size() == 2 && o.lights[0].irradiance == glm::vec3(1, 2, 3) &&
                    distance(o.lights[0].direction, glm::vec3(0, 0.6F, 0.8F)) < 1e-6F &&
                    o.lights[1].direction == glm::vec3(1, 0, 0);
         }},
        {{"--point-light", "-1,2,3:4,5,6", "--point-light=0,0,0:1,1,1"},
         [](const Options& o) {
             return o.point_lights.size() == 2 &&
                    o.point_lights[0].position == glm::vec3(-1, 2, 3) &&
                    o.point_lights[0].intensity == glm::vec3(4, 5, 6);
         }},
        {{"--ambient", "0,1,20"},
         [](const Options& o) { return o.ambient == glm::vec3(0, 1, 20); }},
        {{"--cull", "back"}, [](const Options& o) { return o.settings.cull == Cull::back; }},
        {{"--cull", "back", "--cull", "none"},
         [](const Options& o) { return o.settings.cull == Cull::none; }},
        {{"--raster", "scanline"},
         [](const Options& o) { return o.settings.rasterizer == Rasterizer::scanline; }},
        {{"--raster", "tiles"},
         [](const Options& o) { return o.settings.rasterizer == Rasterizer::tiles; }},
        {{"--lanes", "auto"}, [](const Options& o) { return o.settings.lanes == max_lanes; }},
        {{"--lanes", "1"}, [](const Options& o) { return o.settings.lanes == 1; }},
        {{"--lanes", "4"}, [](const Options& o) { return o.settings.lanes == 4; }},
        {{"--threads", "auto"}, [](const Options& o) { return o.settings.threads >= 1; }},
        {{"--threads", "256"}, [](const Options& o) { return o.settings.threads == 256; }},
        {{"--samples", "16"}, [](const Options& o) { return o.settings.samples == 16; }},
        {{"--samples", "1"}, [](const Options& o) { return o.settings.samples == 1; }},
        {{"--sample-shading"}, [](const Options& o) { return o.settings.sample_shading; }},
        {{"--out", "a.png", "--out", "b.pfm"},
         [](const Options& o) {
             return o.outs == Words{"a.png", "b.pfm"};
         }},
        {{"--view", "shaded"}, [](const Options& o) { return o.view == ViewMode::shaded; }},
        {{"--view", "normal"}, [](const Options& o) { return o.view == ViewMode::normal; }},
        {{"--view", "depth"}, [](const Options& o) { return o.view == ViewMode::depth; }},
        {{"--view", "triangle"}, [](const Options& o) { return o.view == ViewMode::triangle; }},
        {{"--view", "overdraw"}, [](const Options& o) { return o.view == ViewMode::overdraw; }},
        {{"--view", "tiles"}, [](const Options& o) { return o.view == ViewMode::tiles; }},
        {{"--frames", "12"}, [](const Options& o) { return o.frames == 12; }},
        {{"--stats", "-"}, [](const Options& o) { return o.stats == "-"; }},
        {{"--stats", "s.json"}, [](const Options& o) { return o.stats == "s.json"; }},
        {{"--probe", "959,539"}, [](const Options& o) { return o.probe == std::pair(959, 539); }},
        {{"--probe", "3,7", "--size", "4x8"},
         [](const Options& o) { return o.probe == std::pair(3, 7); }},
        {{"--compare", "ref.png"}, [](const Options& o) { return o.compare == "ref.png"; }},
        {{"--window"}, [](const Options& o) { return o.window; }},
        {{"--set", "gain=2.5", "--set", "bend=-1"},
         [](const Options& o) {
             return o.parameters["gain"] == 2.5F && o.parameters["bend"] == -1.0F;
         }},
    };
    for (const auto& c : cases) {
        CAPTURE(c.words.front());
        CAPTURE(c.words.back());
        CHECK(refusal(c.words) == "");
        CHECK(c.arrived(parse(c.words)));
    }
    for (const int lanes : {8, 16}) {
        CHECK(refusal({"--lanes", std::to_string(lanes)}).empty() == has_lanes(lanes));
    }
}

TEST_CASE("what cannot be is refused in one line that names the option and what it allows") {
    const struct {
        const char* option;
        Words values;
        const char* allowed;
    } cases[] = {
        {"--kd", {"2,0,0", "0,-0.1,0", "0,0,1.001"}, "0..1"},
        {"--kd",
         {"1,1", "1,1,1,1", "a,b,c", "", "nan,0,0", "0;0;0", "1, 1, 1", "inf,0,0"},
         "three"},
        {"--ks", {"0,0,7", "-1,0,0"}, "0..1"},
        {"--ks", {"0.5", "red"}, "three"},
        {"--ns", {"-1", "nan", "inf", "1e10", "shiny", "", "5x"}, "0..1e9"},
        {"--size",
         {"0x5", "5x0", "-3x3", "16385x1", "1x16385", "axb", "10", "10x10x10", "1e3x5", "10 x10",
          "99999999999x1", "x", ""},
         "1x1 and 16384x16384"},
        {"--eye", {"1,2", "1,2,3,4", "a,2,3", "1,2,nan", "1,2,inf", "1,,3", ""}, "three"},
        {"--target", {"0", "0,0,x"}, "three"},
        {"--up", {"0,1", "up"}, "three"},
        {"--fov", {"0", "-10", "180", "nan", "wide", ""}, "0.001..179.9"},
        {"--near", {"0", "-1", "nan", "inf", "1e-40", "close"}, "above 0"},
        {"--far", {"0", "-1", "nan", "inf", "1e39", ""}, "above 0"},
        {"--light", {"1,0,0", "1,0,0:1,1,1:2", "", "x"}, "x,y,z:r,g,b"},
        {"--light", {"1,0:1,1,1", "1,0,0:1,1", "nan,0,0:1,1,1"}, "three"},
        {"--light", {"0,0,0:1,1,1"}, "0,0,0"},
        {"--light", {"1,0,0:-1,0,0"}, "never negative"},
        {"--point-light", {"1,0,0", "a:b:c"}, "x,y,z:r,g,b"},
        {"--point-light", {"1,0,0:0,0,-1"}, "never negative"},
        {"--point-light", {"1,0,0:0,0,inf"}, "three finite"},
        {"--ambient", {"-0.1,0,0"}, "never negative"},
        {"--ambient", {"0.1", "x,y,z"}, "three"},
        {"--cull", {"front", "", "BACK"}, "back none"},
        {"--raster", {"gpu", "", "tile"}, "scanline tiles"},
        {"--lanes", {"0", "2", "3", "32", "-4", "many", "", "4.0"}, "auto, 1, 4"},
        {"--threads", {"0", "-1", "257", "two", "1.5", "", "99999999999"}, "1..256"},
        {"--samples", {"0", "3", "5", "32", "-1", "four", ""}, "1 16 2 4 8"},
        {"--out", {"a.jpg", "a", "", "png", "a.png.bak"}, ".png or .pfm"},
        {"--view", {"wireframe", "", "Depth"}, "depth"},
        {"--frames", {"0", "-1", "1000001", "x", "2.5", ""}, "1..1000000"},
        {"--probe", {"1", "1,2,3", "a,b", "1.5,2", ""}, "X,Y"},
        {"--probe", {"960,0", "0,540", "-1,0", "0,-1"}, "0,0..959,539"},
        {"--set", {"gain", "gain=", "gain=a", "gain=1=2", "=", "", "gain=nan"}, "NAME=NUMBER"},
        {"--set", {"gain=11", "gain=-0.1"}, "0..10"},
        {"--set", {"bend=2"}, "-1..1"},
        {"--set", {"gloss=1", "=1"}, "gain bend"},
    };
    for (const auto& c : cases) {
        for (const std::string& value : c.values) {
            const std::string option = c.option;
            CAPTURE(option);
            CAPTURE(value);
            const std::string why = refusal({option, value});
            CHECK(why.starts_with(option + " "));
            CHECK(why.find(c.allowed) != std::string::npos);
            CHECK(why.find('\n') == std::string::npos);
            const std::string joined = refusal({option + "=" + value});
            CHECK((value.empty() ? joined.starts_with(option) : joined == why));
        }
    }
}

TEST_CASE("what is refused together is said together") {
    const std::string why = refusal({"--near", "5", "--far", "2"});
    CHECK(why.find("--near 5") != std::string::npos);
    CHECK(why.find("--far 2") != std::string::npos);
    CHECK(refusal({"--near", "2", "--far", "2"}).find("--near") != std::string::npos);
    CHECK(refusal({"--probe", "4,0", "--size", "4x8"}).find("0,0..3,7") != std::string::npos);
    CHECK(refusal({"--set", "gain=1"}, {}).find("no parameters") != std::string::npos);
}

TEST_CASE("unknown words and missing values are refused, with the way to help") {
    for (const Words& words : {Words{"--no-such-option"},
                               {"--no-such-option", "3"},
                               {"word"},
                               {"-x"},
                               {"--size"},
                               {"--light"},
                               {"--out"},
                               {"--window", "yes"},
                               {"--sample-shading=perhaps"}}) {
        CAPTURE(words.front());
        const std::string why = refusal(words);
        const std::string name = words.front().substr(0, words.front().find('='));
        CHECK((why.find(name) != std::string::npos || why.find("yes") != std::string::npos));
        CHECK(why.find("--help") != std::string::npos);
        CHECK(why.find('\n') == std::string::npos);
    }
}

TEST_CASE("parameters know their names and their limits") {
    Parameters p = two_parameters;
    CHECK(p["gain"] == 1.0F);
    p.set("gain", 10.0F);
    CHECK(p["gain"] == 10.0F);
    CHECK_THROWS_AS(p.set("gain", 10.001F), Error);
    CHECK_THROWS_AS(p.set("gain", std::numeric_limits<float>::quiet_NaN()), Error);
    CHECK_THROWS_AS(p.set("gone", 1.0F), Error);
    CHECK_THROWS_AS(p["gone"], Error);
    CHECK(p["gain"] == 10.0F);
    CHECK(p.all().size() == 2);
    CHECK(Parameters{}.all().empty());
}

}  // namespace
}  // namespace glint
