#include "framework/app/statistics.hpp"

#include "framework/image/file.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <iostream>
#include <locale>
#include <sstream>

namespace glint {
namespace {

struct LeastAndMedian {
    double least, median;
};

LeastAndMedian over_frames(const Drawing& drawing, double Statistics::*stage) {
    std::vector<double> ms;
    for (const Statistics& frame : drawing.frames) {
        ms.push_back(frame.*stage);
    }
    std::sort(ms.begin(), ms.end());
    return {ms.front(), ms[ms.size() / 2]};
}

nlohmann::ordered_json plan_json(const Plan& plan) {
    const auto way = [](const Way& w) {
        return nlohmann::ordered_json{{"ms", w.ms}, {"error", w.error}};
    };
    nlohmann::ordered_json json{{"met", plan.met()},
                                {"full", way(plan.full)},
                                {"chosen", way(plan.chosen)},
                                {"savings", nlohmann::ordered_json::array()}};
    for (const Saving& s : plan.savings) {
        json["savings"].push_back(
            {{"full", s.full}, {"cheaper", s.cheaper}, {"without", way(s.without)}});
    }
    return json;
}

struct Thousands : std::numpunct<char> {
    char do_thousands_sep() const override { return ','; }
    std::string do_grouping() const override { return "\3"; }
};

}  // namespace

std::string summary(const Lesson& lesson, const Options& o, const Drawing& drawing) {
    const auto fragments = drawing.frames.front().fragments_shaded;
    const double ms = over_frames(drawing, &Statistics::frame_ms).least;
    std::ostringstream line;
    line.imbue(std::locale(std::locale::classic(), new Thousands));
    line << lesson.name << ": " << fragments << " fragments";
    line.precision(1);
    line << std::fixed;
    if (fragments > 0) {
        line << ", " << 1e6 * ms / static_cast<double>(fragments) << " ns each";
    }
    line << ", " << ms << " ms, " << o.outs.front();
    return line.str();
}

void write_statistics(const Lesson& lesson, const Options& o, const Drawing& drawing) {
    nlohmann::ordered_json json;
    json["lesson"] = lesson.name;
    json["title"] = lesson.title;
    const auto add = [&](const std::string& name, double Statistics::*stage) {
        const auto [least, median] = over_frames(drawing, stage);
        json[name + "_ms_min"] = least;
        json[name + "_ms_median"] = median;
    };
    add("frame", &Statistics::frame_ms);
    add("geometry", &Statistics::geometry_ms);
    add("visibility", &Statistics::visibility_ms);
    add("shading", &Statistics::shading_ms);
    add("output", &Statistics::output_ms);
    const Statistics& frame = drawing.frames.front();
    json["frames"] = drawing.frames.size();
    json["fragments_shaded"] = frame.fragments_shaded;
    json["tiles_empty"] = frame.tiles_empty;
    json["triangles_in"] = frame.triangles_in;
    json["triangles_visible"] = frame.triangles_visible;
    json["triangles_not_finite"] = frame.triangles_not_finite;
    const bool tiles = o.settings.rasterizer == Rasterizer::tiles;
    json["rasterizer"] = tiles                                           ? "tiles"
                         : o.settings.rasterizer == Rasterizer::scanline ? "scanline"
                                                                         : "reference";
    json["threads"] = tiles ? o.settings.threads : 1;
    json["lanes"] = tiles ? o.settings.lanes : 1;
    json["samples"] = settings_for(o).samples;
    json["instruction_set"] = instruction_set;
    if (o.tolerance > 0) {
        json["tolerance"] = o.tolerance;
        for (const Plan& plan : drawing.plans) {
            json["plans"].push_back(plan_json(plan));
        }
    }
    const std::string text = json.dump(2) + "\n";
    if (o.stats == "-") {
        std::cout << text;
    } else {
        write_text(o.stats, text);
    }
}

}  // namespace glint
