#include "tests/bench/against.hpp"

#include "framework/image/srgb.hpp"
#include "tests/bench/counted.hpp"
#include "tests/bench/llvmpipe.hpp"
#include "tests/bench/peaks.hpp"
#include "tests/bench/pinning.hpp"

#include <array>
#include <iostream>
#include <limits>
#include <optional>

namespace glint {
namespace {

// Operations of one fragment: its normal by planes and 1/w, the way to the eye by one plane each,
// the shader, the sRGB codes.
double operations_of_fragment(const BenchShader& shader) {
    Counted::operations = 0;
    const auto plane = [] { return Counted(0.5F) + Counted(0.1F) * 0.3F + Counted(0.2F) * 0.7F; };
    const Counted w = Counted(1.0F) / plane();
    const auto varying = [&] { return Counted(0.4F) + plane() * w; };
    const BenchShader::Varyings<Counted> in{{varying(), varying(), varying()},
                                            {plane(), plane(), plane()}};
    const Rgb<Counted> c = shader(in);
    for (int channel = 0; channel < 3; ++channel) {
        srgb_code(c[channel]);
    }
    return static_cast<double>(Counted::operations);
}

std::vector<bool> covered_by_alpha(const SrgbImage& picture) {
    std::vector<bool> covered;
    for (const Rgba8& pixel : picture.pixels()) {
        covered.push_back(pixel.a != 0);
    }
    return covered;
}

// What must be read and written at least once.
double bytes_of_frame(const BenchScene& bench) {
    const Mesh& mesh = bench.scene.mesh;
    const auto size = [](const auto& v) { return static_cast<double>(v.size() * sizeof(v[0])); };
    return size(mesh.positions) + size(mesh.normals) + size(mesh.triangles) +
           4.0 * bench.width * bench.height;
}

class Run {
  public:
    Run(const BenchOptions& options, int threads, BenchResult& result)
        : options_(options), threads_(threads), result_(result), pinned_(threads) {
        if (options.against_llvmpipe) {
            peer_.emplace(threads);
            result.peer = peer_->version();
        }
    }

    void scene(const std::string& name) {
        std::cerr << "bench: " << name << ", threads: " << threads_ << "\n";
        const BenchScene bench = bench_scene(name, options_.bunny_file);
        const Settings settings{.lanes = options_.lanes, .threads = threads_, .cull = Cull::back};
        GlintFrames glint(bench, settings);
        SceneResult r = describe(bench, glint);
        time(bench, settings, glint, r);
        if (peer_) {
            r.between = difference(glint.picture(), peer_->picture());
        }
        if (name == "fill" && result_.glint.median_error == 0) {
            judge(bench, glint);
        }
        result_.scenes.push_back(std::move(r));
    }

  private:
    SceneResult describe(const BenchScene& bench, GlintFrames& glint) const {
        const Statistics s = glint.frame();
        SceneResult r{.scene = bench.name,
                      .what = bench.what,
                      .width = bench.width,
                      .height = bench.height,
                      .threads = threads_};
        r.triangles = s.triangles_in;
        r.fragments = s.fragments_shaded;
        r.operations =
            operations_of_fragment(bench_shader(bench.scene)) * static_cast<double>(r.fragments);
        r.bytes = bytes_of_frame(bench);
        return r;
    }

    // All who draw the scene, and the peaks, in turns.
    void time(const BenchScene& bench, const Settings& settings, GlintFrames& glint,
              SceneResult& r) {
        r.stages.frame_ms = std::numeric_limits<double>::infinity();
        const auto draw = [&] {
            const Statistics s = glint.frame();
            r.stages = s.frame_ms < r.stages.frame_ms ? s : r.stages;
        };
        std::vector<std::function<void()>> contenders{draw};
        std::vector<Times*> others;
        const auto add = [&](Times& times, std::function<void()> work) {
            others.push_back(&times);
            contenders.push_back(std::move(work));
        };
        if (peer_) {
            peer_->set_scene(bench);
            add(r.llvmpipe, [this] { peer_->frame(); });
        }
        GlintFrames scalar(bench, {.lanes = 1, .cull = Cull::back});
        GlintFrames scanline(bench, {.rasterizer = Rasterizer::scanline, .cull = Cull::back});
        if (options_.all_ways && threads_ == 1) {
            add(r.scalar, [&] { scalar.frame(); });
            add(r.scanline, [&] { scanline.frame(); });
        }
        // Last, for they flush the caches: what a frame has left there to be written back is not to
        // count as the next one's.
        const BenchShader shader = bench_shader(bench.scene);
        BenchShader whole = shader;
        whole.brdf.highlight_from = -2;
        const std::array<Peak, 4> peaks{straight_kernel(shader, settings.lanes),
                                        straight_kernel(whole, settings.lanes), fma_peak(max_lanes),
                                        write_peak()};
        std::array<Times, peaks.size()> times_of_peaks;
        for (std::size_t i = 0; i < peaks.size(); ++i) {
            add(times_of_peaks[i], peaks[i].work);
        }
        const std::vector<Times> times = time_in_turns(options_.rounds, contenders);
        r.glint = times[0];
        for (std::size_t i = 0; i < others.size(); ++i) {
            *others[i] = times[1 + i];
        }
        const auto in_a_ms = [&](std::size_t i) {
            return peaks[i].amount / times_of_peaks[i].least();
        };
        r.kernel_ns = 1e6 / in_a_ms(0);
        r.whole_ns = 1e6 / in_a_ms(1);
        compare_with_peaks(in_a_ms(2), in_a_ms(3), r);
    }

    // By what one core does in a millisecond.
    void compare_with_peaks(double fma, double write, SceneResult& r) {
        result_.fma_gflops = std::max(result_.fma_gflops, 1e-6 * fma);
        result_.write_gbs = std::max(result_.write_gbs, 1e-6 * write);
        const double core_ms = r.glint.least() * threads_;
        const double clear_ms = 4.0 * r.width * r.height / write;
        const double kernel_ms = 1e-6 * r.kernel_ns * static_cast<double>(r.fragments);
        r.floor_ms = (kernel_ms + clear_ms) / threads_;
        r.share_of_fma = r.operations / (core_ms * fma);
        r.share_of_write = clear_ms / core_ms;
    }

    void judge(const BenchScene& bench, GlintFrames& glint) {
        const ReferencePicture reference = reference_picture(bench);
        LinearImage linear;
        glint.frame(&linear);
        result_.glint = accuracy(reference, linear, glint.picture(), reference.covered);
        if (peer_) {
            const SrgbImage codes = peer_->picture();
            result_.llvmpipe =
                accuracy(reference, peer_->linear_picture(), codes, covered_by_alpha(codes));
        }
    }

    const BenchOptions& options_;
    int threads_;
    BenchResult& result_;
    Pinned pinned_;
    std::optional<Llvmpipe> peer_;
};

}  // namespace

BenchResult run_bench(const BenchOptions& options) {
    BenchResult result{.rounds = options.rounds};
    for (const int threads : options.threads) {
        Run run(options, threads, result);
        for (const std::string& scene : options.scenes) {
            run.scene(scene);
        }
    }
    return result;
}

}  // namespace glint
