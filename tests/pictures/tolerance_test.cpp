// What --tolerance promises: no pixel is further from the double reference, over every lesson's
// stage and over grazing views, high exponents and many samples.
#include "framework/image/pfm.hpp"
#include "framework/image/srgb.hpp"
#include "tests/pictures/lesson_programs.hpp"

#include <doctest/doctest.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>

namespace glint {
namespace {

double code(float linear) {
    return 255 * srgb_encode(std::clamp(double{linear}, 0.0, 1.0));
}

// In codes; above every tolerance where one is not a number.
double largest_difference(const LinearImage& a, const LinearImage& b) {
    REQUIRE(a.pixels().size() == b.pixels().size());
    double largest = 0;
    for (std::size_t i = 0; i < a.pixels().size(); ++i) {
        for (int c = 0; c < 3; ++c) {
            const double d = std::abs(code(a.pixels()[i][c]) - code(b.pixels()[i][c]));
            largest = d <= 255 ? std::max(largest, d) : 1e9;
        }
    }
    return largest;
}

struct Case {
    std::string lesson, words;
};

std::vector<Case> cases() {
    std::vector<Case> all;
    for (const std::string& name : lesson_names()) {
        all.push_back({name, "--samples 2"});
    }
    for (const char* words :
         {"--samples 16 --sample-shading", "--set model=15 --ns 1000", "--set model=15 --ns 0.5",
          "--set model=15 --eye 0,-1,60", "--set model=15 --eye 3,-2,9 --fov 60",
          "--set model=15 --light=1,2,3:9,9,9 --ns 300"}) {
        all.push_back({"15_engine_integration", words});
    }
    return all;
}

TEST_CASE("with a tolerance no pixel is further from the reference") {
    const TemporaryFolder folder;
    REQUIRE(cases().size() >= 20);
    for (const auto& [lesson, words] : cases()) {
        const auto draw = [&](const std::string& more, const std::string& file) {
            const Run r = run(lesson_program(lesson), folder,
                              "--size 80x45 " + words + " " + more + " --out " + file);
            CAPTURE(r.err);
            REQUIRE(r.status == 0);
            return read_pfm(folder / file);
        };
        const LinearImage reference = draw("--raster reference", "reference.pfm");
        for (const char* tolerance : {"4", "1", "0.5", "0.25"}) {
            CAPTURE(lesson);
            CAPTURE(words);
            CAPTURE(tolerance);
            const LinearImage picture = draw(
                "--tolerance " + std::string(tolerance) + " --stats stats.json", "picture.pfm");
            CHECK(largest_difference(reference, picture) <= std::stod(tolerance));
            for (const auto& plan :
                 nlohmann::json::parse(text_of(folder / "stats.json"))["plans"]) {
                CHECK(plan["met"] == true);
                CHECK(plan["chosen"]["error"] <= std::stod(tolerance));
            }
        }
    }
}

}  // namespace
}  // namespace glint
