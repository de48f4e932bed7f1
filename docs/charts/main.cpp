// charts: measures families of methods, writes what it found and brings a document's tables up to
// date. docs/charts/run draws the charts.
#include "framework/image/file.hpp"
#include "framework/math/error.hpp"
#include "framework/math/lane_math.hpp"
#include "docs/charts/families.hpp"
#include "docs/charts/report.hpp"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <cmath>
#include <iostream>

namespace {

using namespace glint;
using namespace glint::charts;

#if defined(__clang__)
constexpr const char* compiler = "Clang " __clang_version__;
#else
constexpr const char* compiler = "GCC " __VERSION__;
#endif

const Family families[] = {
    {"pow", "evaluation", JudgedBy::largest, 301, pow_contenders},
    {"normalise", "evaluation", JudgedBy::largest, 2001, normalise_contenders},
    {"fresnel", "evaluation", JudgedBy::largest, 501, fresnel_contenders},
    {"srgb", "evaluation", JudgedBy::largest, 1001, srgb_contenders},
    {"interpolation", "fragment", JudgedBy::largest, 3001, interpolation_contenders},
    {"shading", "pixel", JudgedBy::rms, 101, shading_contenders},
    {"number_type", "fragment", JudgedBy::rms, 61, number_type_contenders},
    {"antialiasing", "pixel", JudgedBy::rms, 61, antialiasing_contenders},
    {"captured", "evaluation", JudgedBy::rms, 201, captured_contenders},
    {"frames", "pixel", JudgedBy::rms, 25, frames_contenders},
};

// What the numbers depend on.
std::string machine() {
    return "Measured on one core, up to " + std::to_string(max_lanes) + " lanes (" +
           instruction_set + "), compiled by " + compiler + ".\n";
}

void chart(const Family& family, const std::string& results, const std::string& document) {
    const double start = steady_ms();
    std::cerr << family.name << ": ";
    const std::vector<Contender> contenders = family.contenders();
    std::cerr << contenders.size() << " contenders, " << family.rounds << " rounds" << std::flush;
    const std::vector<Row> rows = measure(contenders, family.judged_by, family.rounds);
    write_text(results + "/" + family.name + ".csv", csv(family, rows));
    const std::string text = with_table(read_text(document), "machine", machine());
    write_text(document, with_table(text, family.name, table(family, rows)));
    std::cerr << ", " << std::lround((steady_ms() - start) / 1000) << " s\n";
}

int run(int argc, char** argv) {
    std::string results;
    std::string document;
    std::vector<std::string> chosen;
    std::vector<std::string> names;
    for (const Family& family : families) {
        names.push_back(family.name);
    }
    CLI::App app("Measures the speed and the accuracy of families of methods.", "charts");
    app.add_option("--results", results, "folder for FAMILY.csv")->required();
    app.add_option("--document", document, "Markdown file with marks for tables")->required();
    app.add_option("families", chosen, "which; none: all")->check(CLI::IsMember(names));
    app.footer("Example:\n  charts --results out --document docs/speed-and-accuracy.md pow srgb");
    try {
        app.parse(argc, argv);
    } catch (const CLI::ParseError& e) {
        return app.exit(e) == 0 ? 0 : 2;
    }
    const FlushSubnormals as_the_rasterizers_do;
    for (const Family& family : families) {
        if (chosen.empty() || std::count(chosen.begin(), chosen.end(), family.name) > 0) {
            chart(family, results, document);
        }
    }
    return 0;
}

}  // namespace

int main(int argc, char** argv) {
    try {
        return run(argc, argv);
    } catch (const std::exception& e) {
        std::cerr << "error: " << e.what() << "\n";
        return 2;
    }
}
