// coverage: triangles in pixel coordinates in, the pixels that they cover out.
#include "framework/raster/coverage.hpp"

#include "framework/app/programs/coverage_io.hpp"
#include "framework/app/values.hpp"
#include "framework/math/error.hpp"

#include <CLI/CLI.hpp>

#include <exception>
#include <iostream>

namespace {

using namespace glint;

const char* const about =
    "Reads triangles in pixel coordinates from standard input and prints what they cover.\n"
    "Input, a line a triangle (lines with the same id are a mesh; # begins a comment):\n"
    "  T id width height x0 y0 x1 y1 x2 y2\n"
    "Output, for each case, a line for each run of covered pixels of a row, x_end not included:\n"
    "  T id\n"
    "  y x_begin x_end [index of the triangle, for a mesh]";

void answer(const Settings& settings, int bits) {
    CoverageInput state{.bits = bits, .line = 0, .begun = {}, .text = {}};
    while (const auto c = read_case(std::cin, state)) {
        std::vector<CoverageRun> runs;
        find_coverage(c->triangles, c->width, c->height, settings,
                      [&](int, int triangle, int y, int x_begin, int x_end) {
                          runs.push_back({triangle, y, x_begin, x_end});
                      });
        write_case(std::cout, *c, std::move(runs));
    }
}

void run(int argc, char** argv) {
    CLI::App app{about, "coverage"};
    app.footer("Example:\n  echo 'T t 8 8 0.5 0.5 6 1 2 7' | coverage --raster scanline");
    std::string raster = "tiles";
    std::string lanes = "auto";
    int bits = subpixel_bits;
    app.add_option("--raster", raster, "rasterizer (tiles)")->type_name("tiles|scanline");
    app.add_option("--lanes", lanes, "SIMD lanes of tiles (auto)")->type_name("auto|1|4|8|16");
    app.add_option("--subpixel-bits", bits, "snap positions to 1/2^N pixel (8)")
        ->type_name("N")
        ->check(CLI::Range(0, subpixel_bits));
    try {
        app.parse(argc, argv);
    } catch (const CLI::CallForHelp&) {
        std::cout << app.help();
        return;
    }
    Settings settings;
    settings.rasterizer = choice<Rasterizer>(
        "--raster", raster, {{"tiles", Rasterizer::tiles}, {"scanline", Rasterizer::scanline}});
    settings.lanes = lane_count(lanes);
    answer(settings, bits);
}

}  // namespace

int main(int argc, char** argv) {
    try {
        run(argc, argv);
        return 0;
    } catch (const std::exception& e) {
        std::cerr << "error: " << e.what() << '\n';
        return 2;
    }
}
