// The bench's findings as text and as JSON.
#include "tests/bench/against.hpp"
#include "tests/bench/scaling.hpp"

#include <nlohmann/json.hpp>

#include <cstdarg>
#include <cstdio>

namespace glint {
namespace {

// As printf.
[[gnu::format(printf, 1, 2)]] std::string format(const char* how, ...) {
    char line[512];
    std::va_list values;
    va_start(values, how);
    std::vsnprintf(line, sizeof line, how, values);
    va_end(values);
    return line;
}

std::string row(const SceneResult& r) {
    std::string line =
        format("%-9s %3d %9.2f %9.2f %7.2f %8.2f %7.2f %7.2f %7.1f %5.0f%% %5.0f%%",
               r.scene.c_str(), r.threads, r.glint.least(), r.glint.median(), r.ns_per_fragment(),
               r.kernel_ns, r.whole_ns, r.times_floor(), r.million_triangles_per_second(),
               100 * r.share_of_fma, 100 * r.share_of_write);
    if (!r.llvmpipe.ms.empty()) {
        line += format(" %9.2f %9.2f %7.2f %5d %8.4f", r.llvmpipe.least(), r.llvmpipe.median(),
                       r.times_faster(), r.between.largest, r.between.mean);
    }
    if (!r.scalar.ms.empty()) {
        line += format("\n%9s one lane %.2f ms, %.1f times as long; scanline %.2f ms, %.1f times",
                       "", r.scalar.least(), r.scalar.least() / r.glint.least(), r.scanline.least(),
                       r.scanline.least() / r.glint.least());
    }
    return line + "\n";
}

std::string row(const char* who, const Accuracy& a) {
    return format("%-9s %12.1e %12.1e %9d %11.2f%% %9d\n", who, a.median_error, a.largest_error,
                  a.coverage_differs, 100 * a.share_off_by_one, a.largest_codes);
}

nlohmann::json to_json(const Accuracy& a) {
    return {{"median_relative_error", a.median_error},
            {"largest_relative_error", a.largest_error},
            {"coverage_differs_pixels", a.coverage_differs},
            {"codes_off_share", a.share_off_by_one},
            {"codes_off_largest", a.largest_codes}};
}

nlohmann::json to_json(const Statistics& s) {
    return {{"geometry_ms", s.geometry_ms},
            {"visibility_ms", s.visibility_ms},
            {"shading_ms", s.shading_ms},
            {"output_ms", s.output_ms},
            {"frame_ms", s.frame_ms}};
}

nlohmann::json to_json(const SceneResult& r) {
    nlohmann::json j{{"scene", r.scene},
                     {"what", r.what},
                     {"width", r.width},
                     {"height", r.height},
                     {"threads", r.threads},
                     {"triangles", r.triangles},
                     {"fragments", r.fragments},
                     {"glint_ms_min", r.glint.least()},
                     {"glint_ms_median", r.glint.median()},
                     {"ns_per_fragment", r.ns_per_fragment()},
                     {"kernel_ns_per_fragment", r.kernel_ns},
                     {"whole_model_ns_per_fragment", r.whole_ns},
                     {"floor_ms", r.floor_ms},
                     {"million_triangles_per_second", r.million_triangles_per_second()},
                     {"share_of_fma_peak", r.share_of_fma},
                     {"share_of_write_peak", r.share_of_write},
                     {"operations", r.operations},
                     {"bytes", r.bytes},
                     {"stages", to_json(r.stages)}};
    if (!r.llvmpipe.ms.empty()) {
        j["llvmpipe_ms_min"] = r.llvmpipe.least();
        j["llvmpipe_ms_median"] = r.llvmpipe.median();
        j["times_faster"] = r.times_faster();
        j["difference_max_codes"] = r.between.largest;
        j["difference_mean_codes"] = r.between.mean;
    }
    if (!r.scalar.ms.empty()) {
        j["scalar_ms_min"] = r.scalar.least();
        j["scanline_ms_min"] = r.scanline.least();
    }
    return j;
}

}  // namespace

std::string table(const BenchResult& result) {
    const bool peer = !result.peer.empty();
    std::string text = format("one core: %.0f GFLOP/s of multiply-adds, %.1f GB/s written\n",
                              result.fma_gflops, result.write_gbs);
    if (peer) {
        text += "peer: " + result.peer + "\n";
    }
    text +=
        "\nscene   threads ms, least   median ns/frag   kernel   whole x floor  Mtri/s   FMA  "
        "write";
    text += peer ? "  peer, ms    median   times  largest, mean difference\n" : "\n";
    for (const SceneResult& r : result.scenes) {
        text += row(r);
    }
    if (result.glint.median_error > 0) {
        text +=
            "\nfill      rel. error     largest  coverage    codes off   largest\n"
            "against double  median              px differ                  codes\n";
        text += row("Glint", result.glint);
        if (peer) {
            text += row("llvmpipe", result.llvmpipe);
        }
    }
    return text;
}

nlohmann::json to_json(const BenchResult& result) {
    nlohmann::json j{{"rounds", result.rounds},
                     {"fma_gflops", result.fma_gflops},
                     {"write_gbs", result.write_gbs},
                     {"peer", result.peer},
                     {"instruction_set", instruction_set}};
    for (const SceneResult& r : result.scenes) {
        j["scenes"].push_back(to_json(r));
    }
    j["accuracy"]["glint"] = to_json(result.glint);
    if (!result.peer.empty()) {
        j["accuracy"]["llvmpipe"] = to_json(result.llvmpipe);
    }
    return j;
}

std::string table(const ScalingResult& result) {
    std::string text;
    for (const Scale& scale : result.scales) {
        text += format("%-12s        ms  ns a %-9s slope to the next\n", scale.name.c_str(),
                       scale.unit.c_str());
        for (std::size_t i = 0; i < scale.points.size(); ++i) {
            const ScalePoint& p = scale.points[i];
            text += format("%12.0f %9.3f %13.3f", p.size, p.ms, 1e6 * p.ms / p.size);
            text += i + 1 < scale.points.size() ? format(" %15.2f\n", scale.slope(i)) : "\n";
        }
        text += format("slope of all %9.2f\n\n", scale.slope());
    }
    const Memory& m = result.memory;
    return text + format(
                      "memory: %.1f bytes a triangle with its mesh, %.1f bytes a pixel,\n"
                      "%.0f MB at most for 10 M triangles at 7680x4320, "
                      "%.2f MB more after 1000 frames\n",
                      m.bytes_a_triangle, m.bytes_a_pixel, m.peak_large_mb, m.growth_mb);
}

nlohmann::json to_json(const ScalingResult& result) {
    nlohmann::json j{{"rounds", result.rounds}};
    for (const Scale& scale : result.scales) {
        nlohmann::json points;
        for (const ScalePoint& p : scale.points) {
            points.push_back({{"size", p.size}, {"ms", p.ms}});
        }
        j["scales"].push_back({{"name", scale.name},
                               {"unit", scale.unit},
                               {"points", points},
                               {"slope", scale.slope()}});
    }
    const Memory& m = result.memory;
    j["memory"] = {{"bytes_a_triangle", m.bytes_a_triangle},
                   {"bytes_a_pixel", m.bytes_a_pixel},
                   {"peak_large_mb", m.peak_large_mb},
                   {"growth_mb", m.growth_mb}};
    return j;
}

}  // namespace glint
