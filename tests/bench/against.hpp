// Glint and llvmpipe draw the same scenes in turns.
#pragma once

#include "framework/measure/timing.hpp"
#include "tests/bench/accuracy.hpp"

#include <nlohmann/json_fwd.hpp>

#include <string>
#include <vector>

namespace glint {

struct BenchOptions {
    std::vector<std::string> scenes;
    std::vector<int> threads;  // each count in a run of its own
    int lanes = max_lanes;
    int rounds = 20;
    bool against_llvmpipe = false;
    bool all_ways = false;  // also one lane and scanline, in the run with one thread
    std::string bunny_file;
};

struct SceneResult {
    std::string scene, what;
    int width = 0, height = 0;
    int threads = 1;
    std::int64_t triangles = 0, fragments = 0;
    Times glint{};
    Times llvmpipe{};            // empty if that did not draw
    Times scalar{}, scanline{};  // likewise
    Statistics stages{};         // of Glint's fastest frame
    Difference between{};        // the two pictures
    double operations = 0;       // of floating point, to shade all fragments; counted
    double bytes = 0;            // that no way to draw it can spare: the mesh and the picture
    double kernel_ns = 0;        // a fragment of the straight kernel, a core
    double whole_ns = 0;         // and of the whole model, all highlights everywhere
    double floor_ms = 0;         // the kernel over all fragments, the picture cleared at the peak
    double share_of_fma = 0;     // of the measured peak, counted operations
    double share_of_write = 0;   // of the measured peak, the picture's bytes

    double ns_per_fragment() const {
        return fragments == 0 ? 0 : 1e6 * glint.least() / static_cast<double>(fragments);
    }
    double million_triangles_per_second() const {
        return static_cast<double>(triangles) / (1e3 * glint.least());
    }
    double times_floor() const { return glint.least() / floor_ms; }
    double times_faster() const { return llvmpipe.least() / glint.least(); }
};

struct BenchResult {
    int rounds = 0;                        // of which the least is taken
    std::string peer{};                    // what llvmpipe says it is
    double fma_gflops = 0, write_gbs = 0;  // peaks of one core
    std::vector<SceneResult> scenes{};
    Accuracy glint{}, llvmpipe{};  // on the scene fill, if it was drawn
};

// Draws and measures; tells about its progress on the error stream.
BenchResult run_bench(const BenchOptions& options);

std::string table(const BenchResult& result);
nlohmann::json to_json(const BenchResult& result);

}  // namespace glint
