#include "tests/bench/scaling.hpp"

#include "framework/measure/timing.hpp"
#include "framework/geometry/shapes.hpp"
#include "framework/math/dispatch.hpp"
#include "tests/bench/glint_frames.hpp"

#include <cmath>
#include <fstream>
#include <iostream>
#include <memory>
#include <thread>

namespace glint {
namespace {

const glm::vec3 eye{0, 0, 2.214F};
const Settings fastest{.cull = Cull::back};

// A point of a scale, ready to draw.
struct Job {
    double size;
    BenchScene bench;
    Settings settings;
};

double least_ms(const Job& job, int rounds) {
    GlintFrames frames(job.bench, job.settings);
    const std::function<void()> draw[] = {[&] { frames.frame(); }};
    return time_in_turns(rounds, draw)[0].least();
}

BenchScene fill(int lights = 2) {
    return {"fill", "", bench_sphere(46, 23, eye, lights)};
}

Scale measure(const std::string& name, const std::string& unit, int rounds,
              const std::vector<double>& sizes, const std::function<Job(double)>& make) {
    Scale scale{name, unit};
    for (const double size : sizes) {
        std::cerr << "bench: " << name << " " << size << "\n";
        const Job job = make(size);
        scale.points.push_back({job.size, least_ms(job, rounds)});
    }
    return scale;
}

Job of_pixels(double height) {
    BenchScene b = fill();
    b.height = static_cast<int>(height);
    b.width = b.height * 16 / 9;
    return {static_cast<double>(b.width) * b.height, std::move(b), fastest};
}

Job of_triangles(double triangles) {
    const int rings = static_cast<int>(std::sqrt(triangles / 4));
    BenchScene b{"triangles", "", bench_sphere(2 * rings, rings, eye, 2)};
    const auto size = static_cast<double>(b.scene.mesh.triangles.size());
    return {size, std::move(b), fastest};
}

Job of_lights(double lights) {
    return {lights, fill(static_cast<int>(lights)), fastest};
}

Job of_overdraw(double layers) {
    BenchScene b = fill();
    Mesh all;
    for (int i = 0; i < static_cast<int>(layers); ++i) {  // nearer and nearer
        const auto t = static_cast<float>((i + 1) / layers);
        append(all, sphere(0.9F + 0.1F * t, 46, 23));
    }
    b.scene.mesh = std::move(all);
    return {layers, std::move(b), fastest};
}

Job of_threads(double threads) {
    Settings s = fastest;
    s.threads = static_cast<int>(threads);
    return {threads, fill(), s};
}

Job of_lanes(double lanes) {
    Settings s = fastest;
    s.lanes = static_cast<int>(lanes);
    return {lanes, fill(), s};
}

// A line of /proc/self/status, in MB.
double memory_mb(const std::string& line) {
    std::ifstream status("/proc/self/status");
    for (std::string word; status >> word;) {
        if (word == line + ":") {
            double kb = 0;
            status >> kb;
            return kb / 1024;
        }
    }
    return 0;
}

double resident_mb(const Job& job) {
    const double before = memory_mb("VmRSS");
    GlintFrames frames(job.bench, job.settings);
    frames.frame();
    return memory_mb("VmRSS") - before;
}

Memory measure_memory() {
    std::cerr << "bench: memory\n";
    Memory m;
    const double before = memory_mb("VmRSS");
    const Job many = of_triangles(10e6);
    const double mesh = memory_mb("VmRSS") - before;
    m.bytes_a_triangle = (mesh + resident_mb(many)) * 1048576 / many.size;
    const Job wide = of_pixels(4320);
    m.bytes_a_pixel = resident_mb(wide) * 1048576 / wide.size;
    Job large = of_triangles(10e6);
    large.bench.width = 7680;
    large.bench.height = 4320;
    GlintFrames(large.bench, large.settings).frame();
    m.peak_large_mb = memory_mb("VmHWM");

    const Job small = of_pixels(270);
    GlintFrames frames(small.bench, small.settings);
    double early = 0;
    for (int i = 0; i < 1010; ++i) {
        frames.frame();
        if (i == 9) {
            early = memory_mb("VmRSS");
        }
    }
    m.growth_mb = memory_mb("VmRSS") - early;
    return m;
}

std::vector<double> available_lanes() {
    std::vector<double> all;
    for (const int lanes : {1, 4, 8, 16}) {
        if (has_lanes(lanes)) {
            all.push_back(lanes);
        }
    }
    return all;
}

std::vector<double> available_threads() {
    std::vector<double> all;
    for (unsigned n = 1; n <= std::thread::hardware_concurrency(); n *= 2) {
        all.push_back(n);
    }
    return all;
}

}  // namespace

double Scale::slope() const {
    double x = 0;
    double y = 0;
    double xx = 0;
    double xy = 0;
    const auto n = static_cast<double>(points.size());
    for (const ScalePoint& p : points) {
        const double a = std::log(p.size);
        const double b = std::log(p.ms);
        x += a;
        y += b;
        xx += a * a;
        xy += a * b;
    }
    return (n * xy - x * y) / (n * xx - x * x);
}

double Scale::slope(std::size_t i) const {
    const ScalePoint& a = points[i];
    const ScalePoint& b = points[i + 1];
    return std::log(b.ms / a.ms) / std::log(b.size / a.size);
}

ScalingResult run_scaling(int rounds) {
    ScalingResult r{.rounds = rounds};
    r.memory = measure_memory();
    r.scales = {
        measure("pixels", "pixel", rounds, {180, 360, 540, 1080, 2160, 4320}, of_pixels),
        measure("triangles", "triangle", rounds, {1e3, 1e4, 1e5, 1e6, 1e7}, of_triangles),
        measure("lights", "light", rounds, {1, 4, 16, 64, 256}, of_lights),
        measure("overdraw", "layer", rounds, {1, 4, 16, 64}, of_overdraw),
        measure("lanes", "lane", rounds, available_lanes(), of_lanes),
    };
    if (available_threads().size() > 1) {
        r.scales.push_back(measure("threads", "thread", rounds, available_threads(), of_threads));
    }
    return r;
}

}  // namespace glint
