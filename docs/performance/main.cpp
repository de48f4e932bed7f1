// performance: puts what the bench found into docs/performance.md, and into tables for gnuplot.
// docs/performance/run measures and draws.
#include "framework/image/file.hpp"
#include "framework/math/instruction_set.hpp"
#include "docs/charts/report.hpp"
#include "docs/performance/report.hpp"

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include <fstream>
#include <iostream>
#include <thread>

namespace {

using namespace glint;
using namespace glint::performance;
using nlohmann::json;

#if defined(__clang__)
constexpr const char* compiler = "Clang " __clang_version__;
#else
constexpr const char* compiler = "GCC " __VERSION__;
#endif

// As the system calls it; empty where it does not.
std::string processor() {
    std::ifstream info("/proc/cpuinfo");
    for (std::string line; std::getline(info, line);) {
        if (line.starts_with("model name")) {
            return line.substr(line.find(':') + 2) + ", ";
        }
    }
    return {};
}

std::string machine(const json& bench) {
    const auto whole = [&](const char* key) {
        return std::to_string(std::lround(bench.at(key).get<double>()));
    };
    return "Measured on " + processor() + std::to_string(std::thread::hardware_concurrency()) +
           " cores, up to " + std::to_string(max_lanes) + " lanes (" + instruction_set +
           "), compiled by " + compiler + ". One core does " + whole("fma_gflops") +
           " GFLOP/s of multiply-adds and writes " + whole("write_gbs") +
           " GB/s. Times are the least of " + whole("rounds") +
           " rounds. The peer: " + bench.at("peer").get<std::string>() + ".\n";
}

int run(int argc, char** argv) {
    std::string bench_file;
    std::string scaling_file;
    std::string results;
    std::string document;
    CLI::App app("Puts what the bench found into a text and into tables.", "performance");
    app.add_option("--bench", bench_file, "of bench --against llvmpipe --all-ways --json")
        ->required();
    app.add_option("--scaling", scaling_file, "of bench --scaling --json")->required();
    app.add_option("--results", results, "folder for scenes.csv and scaling.csv")->required();
    app.add_option("--document", document, "Markdown file with marks for tables")->required();
    app.footer(
        "Example:\n  performance --bench bench.json --scaling scaling.json --results out "
        "--document docs/performance.md");
    try {
        app.parse(argc, argv);
    } catch (const CLI::ParseError& e) {
        return app.exit(e) == 0 ? 0 : 2;
    }
    const json bench = json::parse(read_text(bench_file));
    const json scaling = json::parse(read_text(scaling_file));
    write_text(results + "/scenes.csv", scenes_csv(bench));
    write_text(results + "/scaling.csv", scaling_csv(scaling));
    std::string text = read_text(document);
    const std::pair<const char*, std::string> tables[] = {
        {"machine", machine(bench)},         {"scenes", scenes_table(bench)},
        {"llvmpipe", llvmpipe_table(bench)}, {"work", work_table(bench)},
        {"accuracy", accuracy_table(bench)}, {"stages", stages_table(bench)},
        {"ways", ways_table(bench)},         {"scaling", scaling_table(scaling)},
        {"memory", memory_table(scaling)},
    };
    for (const auto& [name, table] : tables) {
        text = charts::with_table(text, name, table);
    }
    write_text(document, text);
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
