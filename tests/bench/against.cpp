#include "tests/bench/against.hpp"

#include "framework/image/srgb.hpp"
#include "tests/bench/counted.hpp"
#include "tests/bench/llvmpipe.hpp"
#include "tests/bench/peaks.hpp"
#include "tests/bench/pinning.hpp"

#include <iostream>
#include <optional>

namespace glint {
namespace {

// Operations of one fragment: varyings by planes and 1/w, the shader, the sRGB codes.
double operations_of_fragment(const BenchShader& shader) {
    Counted::operations = 0;
    const auto plane = [] { return Counted(0.5F) + Counted(0.1F) * 0.3F + Counted(0.2F) * 0.7F; };
    const Counted w = Counted(1.0F) / plane();
    const auto varying = [&] { return Counted(0.4F) + plane() * w; };
    const BenchShader::Varyings<Counted> in{{varying(), varying(), varying()},
                                            {varying(), varying(), varying()}};
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
        GlintFrames glint(bench,
                          {.lanes = options_.lanes, .threads = threads_, .cull = Cull::back});
        const BenchShader shader = bench_shader(bench.scene);
        const Peak kernel = straight_kernel(shader, options_.lanes);
        const Peak fma = fma_peak(max_lanes);
        const Peak write = write_peak();
        std::vector<std::function<void()>> contenders{[&] { glint.frame(); }, kernel.work, fma.work,
                                                      write.work};
        if (peer_) {
            peer_->set_scene(bench);
            contenders.emplace_back([this] { peer_->frame(); });
        }
        const std::vector<Times> times = time_in_turns(options_.rounds, contenders);

        const Statistics s = glint.frame();
        SceneResult r{.scene = name, .threads = threads_, .glint = times[0]};
        r.triangles = s.triangles_in;
        r.fragments = s.fragments_shaded;
        r.kernel_ns = 1e6 * times[1].least() / kernel.amount;
        const double fma_rate = fma.amount / (1e-3 * times[2].least());
        const double write_rate = write.amount / (1e-3 * times[3].least());
        result_.fma_gflops = std::max(result_.fma_gflops, 1e-9 * fma_rate);
        result_.write_gbs = std::max(result_.write_gbs, 1e-9 * write_rate);
        const double seconds = 1e-3 * times[0].least() * threads_;
        r.share_of_fma = operations_of_fragment(shader) * static_cast<double>(r.fragments) /
                         (seconds * fma_rate);
        r.share_of_write = 4.0 * bench.width * bench.height / (seconds * write_rate);
        if (peer_) {
            r.llvmpipe = times[4];
            r.between = difference(glint.picture(), peer_->picture());
        }
        if (name == "fill" && result_.glint.median_error == 0) {
            judge(bench, glint);
        }
        result_.scenes.push_back(std::move(r));
    }

  private:
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
    BenchResult result;
    for (const int threads : options.threads) {
        Run run(options, threads, result);
        for (const std::string& scene : options.scenes) {
            run.scene(scene);
        }
    }
    return result;
}

}  // namespace glint
