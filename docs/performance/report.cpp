#include "docs/performance/report.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <sstream>
#include <vector>

namespace glint::performance {
namespace {

using nlohmann::json;

// Three digits, written out.
std::string number(double value) {
    char text[32];
    const double size = value == 0 ? 1 : std::abs(value);
    const int decimals = std::clamp(2 - static_cast<int>(std::floor(std::log10(size))), 0, 9);
    std::snprintf(text, sizeof text, "%.*f", decimals, value);
    return text;
}

std::string number(const json& j, const char* key) {
    return number(j.at(key).get<double>());
}

std::string small_number(const json& j, const char* key) {
    char text[32];
    std::snprintf(text, sizeof text, "%.1e", j.at(key).get<double>());
    return text;
}

std::string decimals(double value, int count) {
    char text[32];
    std::snprintf(text, sizeof text, "%.*f", count, value);
    return text;
}

std::string percent(const json& j, const char* key) {
    return decimals(100 * j.at(key).get<double>(), 1) + " %";
}

std::string whole(const json& j, const char* key) {
    return std::to_string(j.at(key).get<std::int64_t>());
}

std::string bold_if(bool reached, const std::string& text) {
    return reached ? "**" + text + "**" : text;
}

double ratio(const json& j, const char* above, const char* below) {
    return j.at(above).get<double>() / j.at(below).get<double>();
}

class Table {
  public:
    using Cells = std::vector<std::string>;
    explicit Table(const Cells& names) {
        add(names);
        add(Cells(names.size(), "---"));
    }
    void add(const Cells& cells) {
        text_ += "|";
        for (const std::string& cell : cells) {
            text_ += " " + cell + " |";
        }
        text_ += "\n";
    }
    const std::string& text() const { return text_; }

  private:
    std::string text_;
};

bool has_one_thread(const json& scene) {
    return scene.at("threads") == 1;
}

// The same scene with the most threads.
const json& with_most_threads(const json& bench, const json& scene) {
    const json* most = &scene;
    for (const json& other : bench.at("scenes")) {
        if (other.at("scene") == scene.at("scene") && other.at("threads") > most->at("threads")) {
            most = &other;
        }
    }
    return *most;
}

// Between point i and the next, on logarithmic axes.
double slope(const json& points, std::size_t i) {
    const auto growth = [&](const char* key) {
        return std::log(points[i + 1].at(key).get<double>() / points[i].at(key).get<double>());
    };
    return growth("ms") / growth("size");
}

// The straight line through all points, at one of them.
double fitted_ms(const json& scale, const json& at) {
    double x = 0;
    double y = 0;
    for (const json& p : scale.at("points")) {
        x += std::log(p.at("size").get<double>());
        y += std::log(p.at("ms").get<double>());
    }
    const auto n = static_cast<double>(scale.at("points").size());
    const double from_middle = std::log(at.at("size").get<double>()) - x / n;
    return std::exp(y / n + scale.at("slope").get<double>() * from_middle);
}

}  // namespace

std::string scenes_table(const json& bench) {
    Table table({"scene", "what it is", "picture", "triangles", "fragments"});
    for (const json& s : bench.at("scenes")) {
        if (has_one_thread(s)) {
            table.add({s.at("scene"), s.at("what"), whole(s, "width") + "x" + whole(s, "height"),
                       whole(s, "triangles"), whole(s, "fragments")});
        }
    }
    return table.text();
}

std::string llvmpipe_table(const json& bench) {
    Table table({"scene", "threads", "Glint, ms", "llvmpipe, ms", "times faster",
                 "largest difference, codes", "mean"});
    for (const json& s : bench.at("scenes")) {
        table.add({s.at("scene"), whole(s, "threads"), number(s, "glint_ms_min"),
                   number(s, "llvmpipe_ms_min"), decimals(s.at("times_faster"), 2),
                   whole(s, "difference_max_codes"), decimals(s.at("difference_mean_codes"), 3)});
    }
    return table.text();
}

std::string work_table(const json& bench) {
    Table table({"scene", "threads", "ns a fragment", "straight kernel, ns", "whole model, ns",
                 "times the floor", "Mtriangles/s", "of the FMA peak", "of the write peak"});
    for (const json& s : bench.at("scenes")) {
        table.add({s.at("scene"), whole(s, "threads"), number(s, "ns_per_fragment"),
                   number(s, "kernel_ns_per_fragment"), number(s, "whole_model_ns_per_fragment"),
                   decimals(ratio(s, "glint_ms_min", "floor_ms"), 2),
                   number(s, "million_triangles_per_second"), percent(s, "share_of_fma_peak"),
                   percent(s, "share_of_write_peak")});
    }
    return table.text();
}

std::string accuracy_table(const json& bench) {
    Table table({"against double", "median relative error", "largest", "pixels covered otherwise",
                 "codes that differ", "by at most"});
    for (const auto& [who, key] :
         {std::pair("Glint", "glint"), std::pair("llvmpipe", "llvmpipe")}) {
        const json& a = bench.at("accuracy").at(key);
        table.add({who, small_number(a, "median_relative_error"),
                   small_number(a, "largest_relative_error"), whole(a, "coverage_differs_pixels"),
                   percent(a, "codes_off_share"), whole(a, "codes_off_largest")});
    }
    return table.text();
}

std::string stages_table(const json& bench) {
    Table table({"scene", "threads", "geometry, ms", "visibility, ms", "shading, ms", "output, ms",
                 "frame, ms"});
    for (const json& s : bench.at("scenes")) {
        const json& t = s.at("stages");
        table.add({s.at("scene"), whole(s, "threads"), number(t, "geometry_ms"),
                   number(t, "visibility_ms"), number(t, "shading_ms"), number(t, "output_ms"),
                   number(t, "frame_ms")});
    }
    return table.text();
}

std::string ways_table(const json& bench) {
    Table table({"scene", "all lanes, ms",
                 "one lane, times as long (aim " + decimals(aim_of_lanes, 0) + ")",
                 "one thread beside two, times as long (aim " + decimals(aim_of_threads, 2) + ")",
                 "scanline, times as long"});
    for (const json& s : bench.at("scenes")) {
        if (has_one_thread(s)) {
            const double lanes = ratio(s, "scalar_ms_min", "glint_ms_min");
            const double threads = s.at("glint_ms_min").get<double>() /
                                   with_most_threads(bench, s).at("glint_ms_min").get<double>();
            table.add({s.at("scene"), number(s, "glint_ms_min"),
                       bold_if(lanes >= aim_of_lanes, decimals(lanes, 1)),
                       bold_if(threads >= aim_of_threads, decimals(threads, 2)),
                       decimals(ratio(s, "scanline_ms_min", "glint_ms_min"), 1)});
        }
    }
    return table.text();
}

std::string scaling_table(const json& scaling) {
    Table table({"what grows", "from", "ms", "to", "ms", "slope", "slope from point to point"});
    for (const json& s : scaling.at("scales")) {
        const json& points = s.at("points");
        std::string slopes;
        for (std::size_t i = 0; i + 1 < points.size(); ++i) {
            slopes += (i == 0 ? "" : ", ") + decimals(slope(points, i), 2);
        }
        table.add({s.at("name"), whole(points.front(), "size"), number(points.front(), "ms"),
                   whole(points.back(), "size"), number(points.back(), "ms"),
                   decimals(s.at("slope"), 2), slopes});
    }
    return table.text();
}

std::string memory_table(const json& scaling) {
    const json& m = scaling.at("memory");
    Table table({"memory", ""});
    table.add({"a triangle, its mesh included", number(m, "bytes_a_triangle") + " bytes"});
    table.add({"a pixel, the picture included", number(m, "bytes_a_pixel") + " bytes"});
    table.add({"10 million triangles at 7680x4320, at most", number(m, "peak_large_mb") + " MB"});
    table.add({"growth over 1000 frames", number(m, "growth_mb") + " MB"});
    return table.text();
}

std::string scenes_csv(const json& bench) {
    std::ostringstream out;
    out << "scene,threads,operations_per_byte,gflops,fma_gflops,write_gbs,geometry_ms,"
           "visibility_ms,shading_ms,output_ms,frame_ms\n";
    for (const json& s : bench.at("scenes")) {
        const json& t = s.at("stages");
        out << s.at("scene").get<std::string>() << ',' << s.at("threads") << ','
            << ratio(s, "operations", "bytes") << ','
            << 1e-6 * ratio(s, "operations", "glint_ms_min") << ',' << bench.at("fma_gflops") << ','
            << bench.at("write_gbs") << ',' << t.at("geometry_ms") << ',' << t.at("visibility_ms")
            << ',' << t.at("shading_ms") << ',' << t.at("output_ms") << ',' << t.at("frame_ms")
            << '\n';
    }
    return out.str();
}

std::string scaling_csv(const json& scaling) {
    std::ostringstream out;
    out << "scale,size,ms,fitted_ms,slope\n";
    for (const json& s : scaling.at("scales")) {
        for (const json& p : s.at("points")) {
            out << s.at("name").get<std::string>() << ',' << p.at("size") << ',' << p.at("ms")
                << ',' << fitted_ms(s, p) << ',' << decimals(s.at("slope"), 2) << '\n';
        }
    }
    return out.str();
}

}  // namespace glint::performance
