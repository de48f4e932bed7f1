// What --tolerance promises: no pixel is further from the double reference, over every lesson's
// stage and over grazing views, high exponents and many samples; and over the OBJ files of the
// folder that the environment names as GLINT_MESHES, if it does.
#include "framework/image/pfm.hpp"
#include "framework/image/srgb.hpp"
#include "tests/pictures/lesson_programs.hpp"

#include <doctest/doctest.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>

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
    // The words for the full model, where that is not the default.
    std::string full{};
    // Lessons that have no choice of forms draw the same for any tolerance: the widest one must
    // keep to the narrowest.
    bool chooses = true;
};

std::vector<Case> cases() {
    std::vector<Case> all;
    for (const std::string& name : lesson_names()) {
        const bool fifteen = name == "15_engine_integration";
        const bool seventeen = name == "17_speed_and_accuracy";
        all.push_back(
            {name, "--samples 2", seventeen ? " --set metals=0" : "", fifteen || seventeen});
    }
    for (const char* words :
         {"--samples 16 --sample-shading", "--set model=15 --ns 1000", "--set model=15 --ns 0.5",
          "--set model=15 --eye 0,-1,60", "--set model=15 --eye 3,-2,9 --fov 60",
          "--set model=15 --light=1,2,3:9,9,9 --ns 300"}) {
        all.push_back({"15_engine_integration", words});
    }
    const char* meshes = std::getenv("GLINT_MESHES");
    for (const auto& file : std::filesystem::directory_iterator(meshes ? meshes : ".")) {
        if (meshes != nullptr && file.path().extension() == ".obj") {
            const auto path = std::filesystem::absolute(file.path()).string();
            all.push_back(
                {"17_speed_and_accuracy", "--samples 2 --scene '" + path + "'", " --set metals=0"});
        }
    }
    return all;
}

std::vector<std::pair<std::string, double>> tolerances_and_limits(const Case& c) {
    return c.chooses ? std::vector<std::pair<std::string, double>>{{"4", 4.0},
                                                                   {"1", 1.0},
                                                                   {"0.5", 0.5},
                                                                   {"0.25", 0.25}}
                     : std::vector<std::pair<std::string, double>>{{"4", 0.25}};
}

TEST_CASE("with a tolerance no pixel is further from the reference") {
    const TemporaryFolder folder;
    REQUIRE(cases().size() >= 20);
    for (const Case& c : cases()) {
        const auto draw = [&](const std::string& more, const std::string& file) {
            const Run r = run(lesson_program(c.lesson), folder,
                              "--size 80x45 " + c.words + " " + more + " --out " + file);
            CAPTURE(r.err);
            REQUIRE(r.status == 0);
            return read_pfm(folder / file);
        };
        const LinearImage reference = draw("--raster reference" + c.full, "reference.pfm");
        for (const auto& each : tolerances_and_limits(c)) {
            const std::string& tolerance = each.first;
            const double limit = each.second;
            CAPTURE(c.lesson);
            CAPTURE(c.words);
            CAPTURE(tolerance);
            const LinearImage picture =
                draw("--tolerance " + tolerance + " --stats stats.json", "picture.pfm");
            CHECK(largest_difference(reference, picture) <= limit);
            for (const auto& plan :
                 nlohmann::json::parse(text_of(folder / "stats.json"))["plans"]) {
                CHECK(plan["met"] == true);
                CHECK(plan["chosen"]["error"] <= limit);
                CHECK(plan["chosen"]["ms"] <= plan["full"]["ms"]);
            }
        }
    }
}

TEST_CASE("lesson 17's panels are as near as it says") {
    const TemporaryFolder folder;
    const auto draw = [&](const std::string& words) {
        const Run r = run(lesson_program("17_speed_and_accuracy"), folder,
                          "--size 160x270 " + words + " --out a.pfm");
        REQUIRE(r.status == 0);
        return read_pfm(folder / "a.pfm");
    };
    const auto forms = [](const std::string& metals, const std::string& dielectrics,
                          const std::string& power, const std::string& highlights) {
        return "--set metals=" + metals + " --set dielectrics=" + dielectrics +
               " --set power=" + power + " --set highlights=" + highlights;
    };
    const LinearImage exact = draw("--raster reference " + forms("0", "0", "0", "0"));
    CHECK(largest_difference(exact, draw(forms("3", "2", "1", "3"))) <= 4);
    CHECK(largest_difference(exact, draw(forms("1", "0", "1", "3"))) <= 1);
    CHECK(largest_difference(exact, draw(forms("0", "0", "1", "3"))) <= 0.25);
    CHECK(largest_difference(exact, draw(forms("3", "3", "1", "3"))) > 1);  // it can fail
}

}  // namespace
}  // namespace glint
