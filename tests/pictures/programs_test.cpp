// Every lesson's program: scanline and tiles draw the same picture, in any width of lanes and with
// any number of threads.
#include "framework/image/metrics.hpp"
#include "framework/image/pfm.hpp"
#include "framework/image/png.hpp"
#include "tests/pictures/lesson_programs.hpp"
#include "tests/unit/raster/drawing.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <utility>

namespace glint {
namespace {

// How many pixels are apart by more than 1e-5, relative where they are above 1.
int differing_pixels(const LinearImage& a, const LinearImage& b) {
    REQUIRE(a.width() == b.width());
    REQUIRE(a.height() == b.height());
    int count = 0;
    for (std::size_t i = 0; i < a.pixels().size(); ++i) {
        bool same = true;
        for (int c = 0; c < 3; ++c) {
            const double x = a.pixels()[i][c];
            const double y = b.pixels()[i][c];
            same = same && std::abs(x - y) <= 1e-5 * std::max({1.0, std::abs(x), std::abs(y)});
        }
        count += same ? 0 : 1;  // NaN differs from itself
    }
    return count;
}

class Lesson {
  public:
    Lesson(std::string name, int number) : name_(std::move(name)), number_(number) {
        const int samples[] = {1, 4, 2, 8, 16};
        common_ = "--size 131x70 --samples " + std::to_string(samples[number % 5]) +
                  (number % 2 == 0 ? "" : " --sample-shading") +
                  (number / 2 % 2 == 0 ? "" : " --cull back");
    }

    void check_colours() {
        draw("scanline", "--raster scanline");
        draw("one", tiles() + " --threads 1");
        draw("many", tiles() + " --threads 7");
        CHECK(text_of(folder_ / "one.png") == text_of(folder_ / "many.png"));
        CHECK(text_of(folder_ / "one.pfm") == text_of(folder_ / "many.pfm"));
        const int count =
            differing_pixels(read_pfm(folder_ / "scanline.pfm"), read_pfm(folder_ / "one.pfm"));
        CHECK(count <= 131 * 70 / 200);  // where a model jumps, a rounding may jump with it
    }

    void check_view(const std::string& view) {
        draw("scanline_" + view, "--raster scanline --view " + view);
        draw("tiles_" + view, tiles() + " --threads 2 --view " + view);
        CHECK(text_of(folder_ / ("scanline_" + view + ".pfm")) ==
              text_of(folder_ / ("tiles_" + view + ".pfm")));
    }

  private:
    std::string tiles() const {
        const std::vector<int> lanes = all_lanes();
        const auto turn = static_cast<std::size_t>(number_) % lanes.size();
        return "--raster tiles --lanes " + std::to_string(lanes[turn]);
    }
    void draw(const std::string& file, const std::string& words) {
        const Run r = run(lesson_program(name_), folder_,
                          common_ + " " + words + " --out " + file + ".pfm --out " + file + ".png");
        CAPTURE(r.err);
        REQUIRE(r.status == 0);
    }

    std::string name_, common_;
    int number_;
    TemporaryFolder folder_;
};

TEST_CASE("every lesson's program draws the same by scanline and by tiles") {
    const auto names = lesson_names();
    REQUIRE(!names.empty());
    int number = 0;
    for (const std::string& name : names) {
        CAPTURE(name);
        Lesson lesson(name, number++);
        lesson.check_colours();
        lesson.check_view("triangle");
        lesson.check_view("depth");
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
