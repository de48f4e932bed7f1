// bench: how fast are Glint's tiles, alone or against llvmpipe?
#include "framework/image/file.hpp"
#include "framework/math/error.hpp"
#include "tests/bench/against.hpp"
#include "tests/bench/scaling.hpp"

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include <iostream>
#include <thread>

namespace {

constexpr const char* examples =
    R"(Times are of whole frames: clear, geometry, visibility, shading, sRGB codes; 1920x1080 unless the
scene says otherwise, one sample a pixel, back faces culled. All contenders run in turns, pinned to
as many cores as they have threads; compare minima, for slow spells of the machine only add.
kernel: the same shading over full rows of pixels, with neither triangles nor edges, ns a fragment.
whole: the same with all highlights everywhere, not where they show.
floor: the kernel over all fragments, and the picture cleared at the peak of writing.
FMA, write: share of the measured peaks of the machine.

Examples:
  bench
  bench --against llvmpipe
  bench --against llvmpipe --scenes fill,tiny --threads 1 --rounds 50
  bench --lanes 8 --json bench.json
  bench --scaling)";

void write_json(const std::string& path, const nlohmann::json& findings) {
    if (!path.empty()) {
        glint::write_text(path, findings.dump(2) + "\n");
    }
}

int run(int argc, char** argv) {
    glint::BenchOptions options;
    options.scenes = glint::bench_scene_names();
    options.threads = {1};
    const auto cores = static_cast<int>(std::thread::hardware_concurrency());
    if (cores > 1) {
        options.threads.push_back(cores);
    }
    std::string peer;
    std::string json;
    bool scaling = false;
    CLI::App app("Times Glint's tile rasterizer, alone or against llvmpipe.", "bench");
    app.add_option("--against", peer, "the peer that draws the same")
        ->check(CLI::IsMember({"llvmpipe"}));
    app.add_option("--scenes", options.scenes, "which, with commas between")
        ->delimiter(',')
        ->check(CLI::IsMember(options.scenes));
    app.add_option("--threads", options.threads, "a run for each count")
        ->delimiter(',')
        ->check(CLI::Range(1, 256));
    app.add_option("--lanes", options.lanes, "1, 4, 8 or 16")->check(CLI::IsMember({1, 4, 8, 16}));
    app.add_option("--rounds", options.rounds, "how often each draws")->check(CLI::Range(1, 10000));
    app.add_option("--bunny", options.bunny_file, "an OBJ file to draw as the scene bunny");
    app.add_flag("--all-ways", options.all_ways, "one lane and scanline, too; takes longer");
    app.add_flag("--scaling", scaling, "how the cost grows, by pixels, triangles, lights, ...");
    app.add_option("--json", json, "write all findings to this file");
    app.footer(examples);
    try {
        app.parse(argc, argv);
    } catch (const CLI::ParseError& e) {
        return app.exit(e) == 0 ? 0 : 2;
    }
    if (scaling) {
        const glint::ScalingResult result = glint::run_scaling(options.rounds);
        std::cout << glint::table(result);
        write_json(json, to_json(result));
        return 0;
    }
    options.against_llvmpipe = !peer.empty();
    const glint::BenchResult result = glint::run_bench(options);
    std::cout << glint::table(result);
    write_json(json, to_json(result));
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
