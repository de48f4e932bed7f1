// Reports in other people's forms: their fields, and that words of strangers stay words.
#include "tests/grading/exports/exports.hpp"

#include "framework/image/file.hpp"
#include "framework/image/png.hpp"

#include <doctest/doctest.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cstdlib>
#include <unistd.h>

namespace glint::grading {
namespace {

using nlohmann::json;

CaseResult result(const std::string& name, bool hidden, double points, double earned) {
    const Verdict verdict = earned == points ? Verdict::ok : Verdict::wrong;
    CaseResult c{name,    "values", hidden,       points, earned,
                 verdict, "",       std::nullopt, 0.25,   std::nullopt};
    if (verdict == Verdict::wrong) {
        c.failure = Failure{"float", "ior n", {0.5, 32}, 0, 1.25, 1.25, 7.75, ""};
    }
    return c;
}

Report report() {
    LessonResult right{"09_normalised_phong", Verdict::wrong, "", {}};
    right.tasks = {{"09.1",
                    "the factor",
                    "a lobe without its 1/pi",
                    {result("some <n>", false, 2, 0.6), result("other", true, 2, 0)}},
                   {"09.2", "the lobe", "", {result("in it", false, 1, 1)}}};
    LessonResult broken{"12_schlick",
                        Verdict::compile_error,
                        "a.hpp:1: error: </failure>|`%0A\n",
                        {{"12.1", "F0", "", {result("any", false, 2, 0)}}}};
    broken.tasks[0].cases[0].verdict = Verdict::compile_error;
    return {"=Ada \"the\" <1st>", "course", "aa", "bb", "17", {right, broken}};
}

TEST_CASE("Gradescope") {
    const json j = json::parse(as_gradescope(report()));
    CHECK(j.at("score") == doctest::Approx(1.6));
    CHECK(j.at("stdout_visibility") == "hidden");
    CHECK(!j.contains("output"));
    REQUIRE(j.at("tests").size() == 4);
    double earned = 0;
    for (const json& t : j["tests"]) {
        earned += t.at("score").get<double>();
        CHECK(t.at("visibility") == "visible");
        CHECK(t.at("output_format") == "text");
    }
    CHECK(earned == doctest::Approx(1.6));
    CHECK(j["tests"][0].at("number") == "09.1");
    CHECK(j["tests"][0].at("status") == "failed");
    CHECK(j["tests"][0].at("output").get<std::string>().find("7.75") != std::string::npos);
    CHECK(j["tests"][1].at("output").get<std::string>().find("7.75") == std::string::npos);
    CHECK(j["tests"][2].at("status") == "passed");
}

TEST_CASE("what the grader could not grade says so") {
    Report r = report();
    r.lessons[0].verdict = Verdict::internal_error;
    CHECK(json::parse(as_gradescope(r)).at("output").get<std::string>().find("no grade") !=
          std::string::npos);
    CHECK(json::parse(as_prairielearn(r)).at("gradable") == false);
}

// Of the first case: a picture of a thumbnail's size, of noise, which is the hardest to compress.
Report with_picture() {
    Report r = report();
    SrgbImage noise(3 * 56 + 2, 56);
    std::uint32_t bits = 1;
    for (Rgba8& p : noise.pixels()) {
        bits = bits * 1664525 + 1013904223;
        p = {static_cast<std::uint8_t>(bits >> 24), static_cast<std::uint8_t>(bits >> 16),
             static_cast<std::uint8_t>(bits >> 8), 255};
    }
    r.lessons[0].tasks[0].cases[0].shown = Shown{noise, ""};
    return r;
}

TEST_CASE("pictures go along, small enough for everyone, and come out as they went in") {
    const std::string start = "data:image/png;base64,";
    const json p = json::parse(as_prairielearn(with_picture()));
    const std::string url = p.at("tests")[0].at("images")[0].at("url");
    CHECK(url.starts_with(start));
    CHECK(url.size() < 64 * 1024);
    const json g = json::parse(as_gradescope(with_picture()));
    CHECK(g.at("tests")[0].at("output_format") == "html");
    const std::string output = g["tests"][0].at("output");
    CHECK(output.find(url) != std::string::npos);
    CHECK(output.size() < 64 * 1024);
    CHECK(as_html(with_picture()).find(url) != std::string::npos);
    const auto file = std::filesystem::temp_directory_path() /
                      ("glint_picture_" + std::to_string(getpid()) + ".png");
    write_text(file.string() + ".txt", url.substr(start.size()));
    REQUIRE(std::system(("base64 -d " + file.string() + ".txt >" + file.string()).c_str()) == 0);
    CHECK(read_png(file) == with_picture().lessons[0].tasks[0].cases[0].shown->picture);
    std::filesystem::remove(file);
    std::filesystem::remove(file.string() + ".txt");
}

TEST_CASE("a raster shows which pixels are covered") {
    Report r = report();
    r.lessons[0].tasks[0].cases[0].shown = Shown{{}, "##!\n?..\n"};
    for (const auto form : {as_gradescope, as_prairielearn}) {
        const std::string output = json::parse(form(r)).at("tests")[0].at("output");
        CHECK(output.find("\n##!\n?..\n# covered") != std::string::npos);
    }
    CHECK(as_html(r).find("\n##!\n?..\n# covered") != std::string::npos);
}

TEST_CASE("PrairieLearn and Autolab") {
    const json p = json::parse(as_prairielearn(report()));
    CHECK(p.at("score") == doctest::Approx(1.6 / 7));
    CHECK(p.at("tests")[0].at("max_points") == 2);
    const std::string line = as_autolab(report());
    CHECK(std::count(line.begin(), line.end(), '\n') == 1);
    CHECK(json::parse(line).at("scores").at("09.1") == doctest::Approx(0.6));
}

TEST_CASE("JUnit is XML with the right counts") {
    const std::string xml = as_junit(report());
    CHECK(xml.find("<testsuite name=\"09_normalised_phong\" tests=\"3\" failures=\"2\" "
                   "errors=\"0\" skipped=\"0\">") != std::string::npos);
    CHECK(xml.find("tests=\"1\" failures=\"0\" errors=\"1\"") != std::string::npos);
    CHECK(xml.find("name=\"some &lt;n&gt;\" time=\"0.25\"") != std::string::npos);
    CHECK(xml.find("name=\"other\" time=\"0\"") != std::string::npos);
    CHECK(xml.find("&lt;/failure&gt;") != std::string::npos);
}

TEST_CASE("Markdown, annotations, HTML and CSV keep strangers' words in their place") {
    const std::string table = as_github(report());
    CHECK(table.find("&lt;/failure&gt;\\|`%0A<br>") != std::string::npos);
    CHECK(std::count(table.begin(), table.end(), '\n') == 6);
    const std::string lines = github_annotations(report());
    CHECK(std::count(lines.begin(), lines.end(), '\n') == 2);
    CHECK(lines.find("%250A%0A\n") != std::string::npos);
    CHECK(as_html(report()).find("<1st>") == std::string::npos);
    const std::string csv = as_csv(report());
    CHECK(csv.starts_with("\"'=Ada \"\"the\"\" <1st>\",1.6,7,yes,0.6,1,wrong,0,compile error,"));
    const std::string head = csv_head(report());
    CHECK(std::count(head.begin(), head.end(), ',') == std::count(csv.begin(), csv.end(), ','));
}

TEST_CASE("hidden cases tell nothing but points, in any form students see") {
    for (const auto form : {as_gradescope, as_prairielearn, as_junit, as_github, as_html}) {
        Report r = report();
        r.lessons.resize(1);
        r.lessons[0].tasks[0].cases[0] = result("some", false, 2, 2);
        CHECK(form(r).find("7.75") == std::string::npos);
        const std::string wrong = form(r);
        CaseResult& hidden = r.lessons[0].tasks[0].cases[1];
        hidden.verdict = Verdict::crash;
        hidden.failure.reset();
        hidden.words = "a signal";
        CHECK(form(r) == wrong);  // nor how the answer failed
    }
}

TEST_CASE("a failure names the numbers that were asked") {
    CaseResult c = result("some", false, 2, 0);
    c.failure->of = "N[3] n";
    c.failure->question = {0, 0.5, 1, 32};
    CHECK(explain(c) ==
          "some: for N = (0, 0.5, 1), n = 32, as float, you make 7.75, it is to be 1.25");
}

}  // namespace
}  // namespace glint::grading
