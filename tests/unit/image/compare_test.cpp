// The program compare as its users meet it: exit codes, standard output, files.
#include "framework/image/convert.hpp"
#include "framework/image/file.hpp"
#include "framework/image/pfm.hpp"
#include "framework/image/srgb.hpp"
#include "tests/temporary.hpp"
#include "tests/unit/image/pictures.hpp"

#include <doctest/doctest.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cstdlib>
#include <sys/wait.h>

namespace glint {
namespace {

using nlohmann::json;

std::string text_of(const std::filesystem::path& path) {
    const auto bytes = read_file(path);
    return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

struct Run {
    int status;
    std::string out, err;
};

// Runs compare in the folder of the sources; its files lie in folder.
Run run(const TemporaryFolder& folder, const std::string& arguments) {
    const std::string command = std::string("'") + COMPARE_PROGRAM + "' " + arguments + " > '" +
                                (folder / "out").string() + "' 2> '" + (folder / "err").string() +
                                "'";
    const int result = std::system(command.c_str());
    REQUIRE(WIFEXITED(result));
    return {WEXITSTATUS(result), text_of(folder / "out"), text_of(folder / "err")};
}

const std::string sphere = "tests/data/metrics/sphere.png ";
const std::string noise = "tests/data/metrics/sphere_noise.png ";

bool is_one_line(const std::string& text) {
    return std::ranges::count(text, '\n') == 1 && text.ends_with('\n');
}

TEST_CASE("standard output is the JSON and nothing else") {
    const TemporaryFolder folder;
    const Run result = run(folder, sphere + noise + "--json -");
    CHECK(result.status == 0);
    CHECK(result.err.empty());
    const json numbers = json::parse(result.out);
    CHECK(numbers.size() == 11);
    CHECK(numbers["max"] == 34);
    CHECK(numbers["rmse"].get<double>() == doctest::Approx(7.540162));
    CHECK(numbers["psnr"].get<double>() == doctest::Approx(30.5832));
    CHECK(numbers["ssim"].get<double>() == doctest::Approx(0.700977));
    CHECK(numbers["flip_mean"].get<double>() == doctest::Approx(0.0763).epsilon(1e-4));
    CHECK(numbers["flip_max"].get<double>() == doctest::Approx(0.230994).epsilon(1e-4));
    CHECK(numbers["over_one"].get<double>() == doctest::Approx(0.995226));
    CHECK(numbers["worst_x"] == 92);
    CHECK(numbers["worst_y"] == 57);
    CHECK(numbers["worst_reference"] == json::array({255, 159, 160}));
    CHECK(numbers["worst_test"] == json::array({255, 156, 126}));
}

TEST_CASE("the infinite psnr of equal pictures is null") {
    const TemporaryFolder folder;
    const Run result = run(folder, sphere + sphere + "--json -");
    CHECK(result.status == 0);
    CHECK(json::parse(result.out)["psnr"].is_null());
}

TEST_CASE("JSON in a file leaves the table on standard output") {
    const TemporaryFolder folder;
    const Run result = run(folder, sphere + noise + "--json " + (folder / "a.json").string());
    CHECK(result.status == 0);
    CHECK(json::parse(text_of(folder / "a.json"))["max"] == 34);
    CHECK(result.out.find("flip_mean") != std::string::npos);
    CHECK(result.out.find(" 92 57 ") != std::string::npos);
    CHECK(result.out.find(": 255 156 126, was 255 159 160\n") != std::string::npos);
}

Run run_with_limit(const TemporaryFolder& folder, const char* option, const char* limit) {
    return run(folder, sphere + noise + "--json - " + option + " " + limit);
}

TEST_CASE("each limit is kept where met and named where passed") {
    const TemporaryFolder folder;
    const struct {
        const char *name, *met, *passed;
    } limits[] = {{"--max-max", "34", "33"},
                  {"--max-rmse", "7.55", "7.5"},
                  {"--min-psnr", "30.5", "30.6"},
                  {"--min-ssim", "0.70", "0.71"},
                  {"--max-flip-mean", "0.077", "0.076"},
                  {"--max-flip-max", "0.231", "0.230"},
                  {"--max-over-one", "0.996", "0.995"}};
    for (const auto& limit : limits) {
        CAPTURE(limit.name);
        CHECK(run_with_limit(folder, limit.name, limit.met).status == 0);
        const Run result = run_with_limit(folder, limit.name, limit.passed);
        CHECK(result.status == 1);
        CHECK(is_one_line(result.err));
        CHECK(result.err.find(limit.name) != std::string::npos);
        CHECK(json::accept(result.out));
    }
    CHECK(run(folder, sphere + sphere + "--max-max 0 --min-psnr 1000 --min-ssim 0.9999").status ==
          0);
    CHECK(run(folder, sphere + sphere + "--max-max nan").status == 1);
}

TEST_CASE("pictures are written") {
    const TemporaryFolder folder;
    const std::string heat = (folder / "heat.png").string();
    const std::string all = (folder / "all.png").string();
    CHECK(run(folder, sphere + noise + "--heatmap " + heat + " --side-by-side " + all).status == 0);
    CHECK(read_png(heat).width() == 192);
    CHECK(read_png(all).width() == 3 * 192 + 4);
    CHECK(read_png(all)(1, 1) == metric_picture("sphere")(1, 1));
    CHECK(read_png(all)(2 * 194, 0) == read_png(heat)(0, 0));
}

TEST_CASE("PFM is compared as sRGB codes") {
    const TemporaryFolder folder;
    write_pfm(folder / "a.pfm", to_linear(metric_picture("sphere")));
    const Run result = run(folder, (folder / "a.pfm").string() + " " + noise + "--json -");
    CHECK(result.status == 0);
    CHECK(json::parse(result.out)["max"] == 34);
}

TEST_CASE("of two PFM the largest difference is said before codes are rounded, too") {
    const TemporaryFolder folder;
    LinearImage a(16, 16);
    std::ranges::fill(a.pixels(), Rgb<float>(0.5F));
    LinearImage b = a;
    b(3, 5).g = 0.501F;
    write_pfm(folder / "a.pfm", a);
    write_pfm(folder / "b.pfm", b);
    const std::string both = (folder / "a.pfm").string() + " " + (folder / "b.pfm").string() + " ";
    const json numbers = json::parse(run(folder, both + "--json -").out);
    const double exact = 255 * (srgb_encode(double{0.501F}) - srgb_encode(0.5));
    CHECK(numbers["unrounded"].get<double>() == doctest::Approx(exact));
    CHECK(exact > 0.15);
    CHECK(numbers["max"] == 0);
    CHECK(run(folder, both).out.find("unrounded") != std::string::npos);
    CHECK_FALSE(json::parse(run(folder, sphere + noise + "--json -").out).contains("unrounded"));
}

TEST_CASE("what cannot be done is one line and exit status 2") {
    const TemporaryFolder folder;
    write_png(folder / "small.png", grey_picture(64, 64, 0));
    const std::string small = (folder / "small.png").string();
    for (const std::string& arguments :
         {std::string(), sphere, sphere + "no/such.png", sphere + "LICENSE", sphere + small,
          sphere + noise + "--no-such-option", sphere + noise + "--max-max much",
          sphere + noise + "third.png", sphere + noise + "--json no/such/folder.json",
          sphere + noise + "--heatmap no/such/folder.png", "no/such.pfm " + noise,
          sphere + noise + "--json /dev/full"}) {
        CAPTURE(arguments);
        const Run result = run(folder, arguments);
        CHECK(result.status == 2);
        CHECK(result.err.starts_with("error: "));
        CHECK(is_one_line(result.err));
    }
    CHECK(run(folder, sphere + small).err.find("192x108") != std::string::npos);
}

TEST_CASE("--help explains itself and is no failure") {
    const TemporaryFolder folder;
    const Run result = run(folder, "--help");
    CHECK(result.status == 0);
    CHECK(result.out.find("Examples:") != std::string::npos);
    CHECK(result.out.find("--max-flip-mean") != std::string::npos);
}

}  // namespace
}  // namespace glint
