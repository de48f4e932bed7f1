// Every lesson's program: scanline and tiles draw the same picture, in any width of lanes and with
// any number of threads.
#include "framework/image/metrics.hpp"
#include "framework/image/pfm.hpp"
#include "framework/image/png.hpp"
#include "tests/pictures/lesson_programs.hpp"
#include "tests/unit/raster/drawing.hpp"
#include "tests/worst.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <map>
#include <utility>

namespace glint {
namespace {

// How far colours may differ; in highlights of exponents above 100 as much more as these enlarge
// the last place of V.R.
double allowed(const std::string& lesson) {
    const std::map<std::string, double> exponents = {
        {"01_ad_hoc_phong", 120}, {"09_normalised_phong", 2048}, {"17_speed_and_accuracy", 120.5}};
    const auto found = exponents.find(lesson);
    return found == exponents.end() ? 1e-5 : found->second / 100 * 1e-5;
}

// By how much a pixel differs at most, relative where it is above 1; infinity for NaN.
double largest_difference(const LinearImage& a, const LinearImage& b) {
    REQUIRE(a.width() == b.width());
    REQUIRE(a.height() == b.height());
    double largest = 0;
    for (std::size_t i = 0; i < a.pixels().size(); ++i) {
        for (int c = 0; c < 3; ++c) {
            const double x = a.pixels()[i][c];
            const double y = b.pixels()[i][c];
            const double difference = std::abs(x - y) / std::max({1.0, std::abs(x), std::abs(y)});
            largest = worse(largest, difference);
        }
    }
    return largest;
}

class Lesson {
  public:
    // common: words of the command line.
    Lesson(std::string name, std::string common)
        : name_(std::move(name)), common_(std::move(common)) {
        draw("scanline_shaded", "--raster scanline");
    }

    void check_colours(int lanes) {
        draw("one", tiles(lanes, 1) + " --out one.png");
        CHECK(largest_difference(read_pfm(folder_ / "scanline_shaded.pfm"),
                                 read_pfm(folder_ / "one.pfm")) <= allowed(name_));
    }

    // After check_colours() with as many lanes.
    void check_threads(int lanes) {
        for (const int threads : {2, 7}) {
            draw("many", tiles(lanes, threads) + " --out many.png");
            CHECK(text_of(folder_ / "one.png") == text_of(folder_ / "many.png"));
            CHECK(text_of(folder_ / "one.pfm") == text_of(folder_ / "many.pfm"));
        }
    }

    void draw_views() {
        for (const std::string view : {"triangle", "depth"}) {
            draw("scanline_" + view, "--raster scanline --view " + view);
        }
    }

    // After draw_views().
    void check_view(const std::string& view, int lanes) {
        draw("tiles", tiles(lanes, 2) + " --view " + view);
        CHECK(text_of(folder_ / ("scanline_" + view + ".pfm")) == text_of(folder_ / "tiles.pfm"));
    }

  private:
    static std::string tiles(int lanes, int threads) {
        return "--raster tiles --lanes " + std::to_string(lanes) + " --threads " +
               std::to_string(threads);
    }
    void draw(const std::string& file, const std::string& words) {
        const Run r =
            run(lesson_program(name_), folder_, common_ + " " + words + " --out " + file + ".pfm");
        CAPTURE(r.err);
        REQUIRE(r.status == 0);
    }

    std::string name_, common_;
    TemporaryFolder folder_;
};

TEST_CASE("every lesson's program draws the same by scanline and by tiles") {
    const auto names = lesson_names();
    REQUIRE(!names.empty());
    int number = 0;
    for (const std::string& name : names) {
        CAPTURE(name);
        const int samples[] = {1, 4, 2, 8, 16};
        Lesson lesson(name, "--size 131x70 --samples " + std::to_string(samples[number % 5]) +
                                (number % 2 == 0 ? "" : " --sample-shading") +
                                (number / 2 % 2 == 0 ? "" : " --cull back"));
        ++number;
        lesson.draw_views();
        for (const int lanes : all_lanes()) {
            CAPTURE(lanes);
            lesson.check_colours(lanes);
            lesson.check_threads(lanes);
            lesson.check_view("triangle", lanes);
            lesson.check_view("depth", lanes);
        }
    }
}

TEST_CASE("and so at the size and with the samples that it has without options") {
    if (*EMULATOR != '\0') {
        return;  // there it takes minutes
    }
    for (const std::string& name : lesson_names()) {
        CAPTURE(name);
        Lesson lesson(name, "");
        for (const int lanes : all_lanes()) {
            CAPTURE(lanes);
            lesson.check_colours(lanes);
        }
    }
}

TEST_CASE("every lesson's program draws its golden, as lessons/run --check holds it") {
    const TemporaryFolder folder;
    for (const std::string& name : lesson_names()) {
        CAPTURE(name);
        REQUIRE(run(lesson_program(name), folder, "--out mine.png").status == 0);
        const Metrics m = measure_difference(read_png("assets/golden/" + name + ".png"),
                                             read_png(folder / "mine.png"));
        CHECK(m.rmse <= 0.05);
        CHECK(m.over_one <= 0.0001);
    }
}

}  // namespace
}  // namespace glint
