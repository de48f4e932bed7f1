#include "framework/app/window_words.hpp"

#include "framework/app/picture.hpp"
#include "framework/app/window_keys.hpp"

#include <algorithm>
#include <array>
#include <cstdio>

namespace glint {
namespace {

std::string padded(std::string_view text, std::size_t width) {
    std::string out(text);
    out.resize(std::max(width, out.size()), ' ');
    return out;
}

std::string counted(int count, const std::string& what) {
    return std::to_string(count) + " " + what + (count == 1 ? "" : "s");
}

std::string time_line(const Options& o, const Statistics& frame) {
    std::string line = formatted("%.2f ms", frame.frame_ms);
    if (frame.fragments_shaded > 0) {
        line += formatted(", %.1f ns a fragment",
                          1e6 * frame.frame_ms / static_cast<double>(frame.fragments_shaded));
    }
    return line + ", " + std::to_string(o.width) + "x" + std::to_string(o.height);
}

std::string rasterizer_line(const Settings& s) {
    const bool tiles = s.rasterizer == Rasterizer::tiles;
    return (tiles ? "tiles, " + counted(s.lanes, "lane") + ", " + counted(s.threads, "thread")
                  : std::string("scanline, 1 lane, 1 thread")) +
           ", " + counted(s.samples, "sample") + (s.cull == Cull::back ? ", culling" : "");
}

std::string parameter_line(const std::vector<Parameter>& all, std::size_t chosen) {
    const Parameter& p = all[chosen];
    return formatted("[%.0f/", static_cast<double>(chosen + 1)) +
           formatted("%.0f] ", static_cast<double>(all.size())) + p.name +
           formatted(" = %.4g", p.value) + formatted(" (%.4g..", p.low) +
           formatted("%.4g)", p.high);
}

}  // namespace

std::string formatted(const char* format, double number) {
    std::array<char, 64> text{};
    std::snprintf(text.data(), text.size(), format, number);
    return text.data();
}

Lines status_lines(const Options& o, const Statistics& frame, std::size_t chosen_parameter) {
    constexpr std::array views{"shaded", "normal", "depth", "triangle", "overdraw", "tiles"};
    Lines lines{time_line(o, frame), rasterizer_line(settings_for(o)),
                std::string("view ") + views[static_cast<std::size_t>(o.view)]};
    if (chosen_parameter < o.parameters.all().size()) {
        lines.push_back(parameter_line(o.parameters.all(), chosen_parameter));
        lines.push_back(o.parameters.all()[chosen_parameter].meaning);
    }
    return lines;
}

Lines report_lines(const PixelReport& report) {
    Lines lines = report.words;
    std::size_t width = 0;
    for (const Reading& r : report.readings) {
        width = std::max(width, r.name.size());
    }
    if (!report.readings.empty()) {
        lines.push_back(padded("", width) + "         float        double difference");
    }
    for (const Reading& r : report.readings) {
        lines.push_back(padded(r.name, width) + formatted(" %13.7g", r.in_float) +
                        formatted(" %13.7g", r.in_double) +
                        formatted(" %10.1e", r.in_float - r.in_double));
    }
    return lines;
}

Lines key_lines() {
    std::size_t width = 0;
    for (const KeyHelp& line : key_help()) {
        width = std::max(width, line.keys.size());
    }
    Lines lines;
    for (const KeyHelp& line : key_help()) {
        lines.push_back(padded(line.keys, width + 2) + std::string(line.meaning));
    }
    return lines;
}

std::string difference_line(const CodeDifference& d, const std::string& name) {
    if (d.largest == 0) {
        return "no difference from " + name;
    }
    return "against " + name + ": largest " + std::to_string(d.largest) + " of 255 codes at " +
           std::to_string(d.x) + "," + std::to_string(d.y) +
           formatted(", %.3g %% of pixels differ", 100 * d.share);
}

}  // namespace glint
