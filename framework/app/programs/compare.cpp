// compare REFERENCE TEST: how different are two pictures? Numbers, heat maps and limits.
#include "framework/image/convert.hpp"
#include "framework/image/file.hpp"
#include "framework/image/flip.hpp"
#include "framework/image/heat_map.hpp"
#include "framework/image/metrics.hpp"
#include "framework/image/pfm.hpp"
#include "framework/image/png.hpp"
#include "framework/math/error.hpp"

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include <cmath>
#include <cstdio>
#include <filesystem>
#include <optional>
#include <string>

namespace glint {
namespace {

// One number of the comparison: what it is called, what it was, what it may be.
struct Field {
    const char* name;
    double Metrics::*value;
    bool more_is_better;
    const char* option;
    const char* meaning;
    std::optional<double> limit{};

    bool passes(double x) const { return !limit || (more_is_better ? x >= *limit : x <= *limit); }
};

std::vector<Field> all_fields() {
    return {
        {"max", &Metrics::max, false, "--max-max", "largest difference, in codes of 0..255"},
        {"rmse", &Metrics::rmse, false, "--max-rmse", "root mean squared difference, in codes"},
        {"psnr", &Metrics::psnr, true, "--min-psnr", "peak signal to noise ratio, in dB"},
        {"ssim", &Metrics::ssim, true, "--min-ssim", "structural similarity, 1 if equal"},
        {"flip_mean", &Metrics::flip_mean, false, "--max-flip-mean", "mean FLIP, 0..1"},
        {"flip_max", &Metrics::flip_max, false, "--max-flip-max", "largest FLIP, 0..1"},
        {"over_one", &Metrics::over_one, false, "--max-over-one",
         "share of pixels off by more than one code, 0..1"},
    };
}

struct Options {
    std::string reference, test;
    std::string json, heatmap, side_by_side;
    std::vector<Field> fields = all_fields();
};

constexpr const char* examples =
    R"(Files that end in .pfm are read as PFM and compared as sRGB codes, all others as PNG. Of two
PFM files "unrounded" is the largest difference before the codes are rounded.
The psnr of equal pictures is infinite, which JSON writes as null.

Exit status: 0, 1 where a limit is passed, 2 where something cannot be read or written.

Examples:
  compare golden.png mine.png
  compare golden.png mine.png --max-max 2 --max-flip-mean 0.01
  compare golden.png mine.png --heatmap heat.png --side-by-side all.png
  compare golden.pfm mine.pfm --json -)";

void declare(CLI::App& app, Options& options) {
    app.add_option("REFERENCE", options.reference, "the picture as it should be")->required();
    app.add_option("TEST", options.test, "the picture to judge")->required();
    app.add_option("--json", options.json, "write the numbers as JSON; - is standard output");
    app.add_option("--heatmap", options.heatmap, "write FLIP as a PNG, black for no difference");
    app.add_option("--side-by-side", options.side_by_side,
                   "write reference, test and heat map as one PNG");
    for (Field& field : options.fields) {
        app.add_option(field.option, field.limit,
                       std::string("limit of ") + field.name + ": " + field.meaning);
    }
    app.footer(examples);
}

bool is_pfm(const std::filesystem::path& path) {
    return path.extension() == ".pfm";
}

SrgbImage read_picture(const std::filesystem::path& path) {
    return is_pfm(path) ? to_srgb(read_pfm(path)) : read_png(path);
}

// What the metrics leave out: the pixel that differs most, in both pictures, and of linear ones the
// largest difference in codes that are not rounded.
struct Details {
    Rgba8 reference, test;
    std::optional<double> unrounded;
};

std::string words(const Rgba8& p) {
    return std::to_string(p.r) + " " + std::to_string(p.g) + " " + std::to_string(p.b);
}

std::string as_json(const Options& options, const Metrics& metrics, const Details& details) {
    nlohmann::ordered_json json;
    for (const Field& field : options.fields) {
        const double value = metrics.*field.value;
        json[field.name] = std::isfinite(value) ? nlohmann::ordered_json(value) : nullptr;
    }
    if (details.unrounded) {
        json["unrounded"] = *details.unrounded;
    }
    json["worst_x"] = metrics.worst_x;
    json["worst_y"] = metrics.worst_y;
    json["worst_reference"] = {details.reference.r, details.reference.g, details.reference.b};
    json["worst_test"] = {details.test.r, details.test.g, details.test.b};
    return json.dump(2) + "\n";
}

void print_table(const Options& options, const Metrics& metrics, const Details& details) {
    for (const Field& field : options.fields) {
        std::printf("%-10s %12.6g   %s\n", field.name, metrics.*field.value, field.meaning);
    }
    if (details.unrounded) {
        std::printf("%-10s %12.6g   largest difference, in codes that are not rounded\n",
                    "unrounded", *details.unrounded);
    }
    const auto place = std::to_string(metrics.worst_x) + " " + std::to_string(metrics.worst_y);
    std::printf("%-10s %12s   x y of the first pixel with the largest difference: %s, was %s\n",
                "worst", place.c_str(), words(details.test).c_str(),
                words(details.reference).c_str());
}

void write_numbers(const Options& options, const Metrics& metrics, const Details& details) {
    const std::string json = as_json(options, metrics, details);
    if (options.json == "-") {
        std::fputs(json.c_str(), stdout);
    } else {
        print_table(options, metrics, details);
    }
    if (std::fflush(stdout) != 0) {
        throw Error("cannot write to standard output");
    }
    if (!options.json.empty() && options.json != "-") {
        write_text(options.json, json);
    }
}

void write_pictures(const Options& options, const SrgbImage& reference, const SrgbImage& test) {
    if (options.heatmap.empty() && options.side_by_side.empty()) {
        return;
    }
    const SrgbImage heat = heat_map(flip_map(reference, test));
    if (!options.heatmap.empty()) {
        write_png(options.heatmap, heat);
    }
    if (!options.side_by_side.empty()) {
        write_png(options.side_by_side, side_by_side(reference, test, heat));
    }
}

// Says on stderr which limits are passed, and returns the exit status.
int judge(const Options& options, const Metrics& metrics) {
    int status = 0;
    for (const Field& field : options.fields) {
        const double value = metrics.*field.value;
        if (!field.passes(value)) {
            std::fprintf(stderr, "%s is %.6g, %s %.6g is the limit\n", field.name, value,
                         field.option, *field.limit);
            status = 1;
        }
    }
    return status;
}

int compare(const Options& options) {
    const SrgbImage reference = read_picture(options.reference);
    const SrgbImage test = read_picture(options.test);
    const Metrics metrics = measure_difference(reference, test);
    write_pictures(options, reference, test);
    Details details{.reference = reference(metrics.worst_x, metrics.worst_y),
                    .test = test(metrics.worst_x, metrics.worst_y),
                    .unrounded = {}};
    if (is_pfm(options.reference) && is_pfm(options.test)) {
        details.unrounded =
            largest_code_difference(read_pfm(options.reference), read_pfm(options.test));
    }
    write_numbers(options, metrics, details);
    return judge(options, metrics);
}

}  // namespace
}  // namespace glint

int main(int argc, char** argv) {
    try {
        CLI::App app("Compares a picture with its reference.", "compare");
        glint::Options options;
        glint::declare(app, options);
        try {
            app.parse(argc, argv);
        } catch (const CLI::ParseError& e) {
            if (e.get_exit_code() == 0) {
                return app.exit(e);  // --help
            }
            throw glint::Error(std::string(e.what()) + "; see compare --help");
        }
        return glint::compare(options);
    } catch (const std::exception& e) {
        std::fprintf(stderr, "error: %s\n", e.what());
        return 2;
    }
}
