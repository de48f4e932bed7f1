// gallery PROJECT OUT LESSON...: one page of all lessons, OUT/index.html, that needs no other file.
//
// Of each lesson it reads what lessons/run leaves in OUT, the picture NAME.png and the statistics
// NAME.json, and of it and the one before, A_to_B.heat.png and A_to_B.json; further, where they
// are, the heading of lessons/NAME/README.md and lessons/NAME/formula.mathml. All of
// docs/charts/results/*.svg comes last. How it looks is told by gallery.html.
#include "framework/app/programs/page.hpp"
#include "framework/image/file.hpp"
#include "framework/image/heat_map.hpp"
#include "framework/math/error.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <string>
#include <vector>

namespace {

using namespace glint;
using nlohmann::json;
namespace fs = std::filesystem;

struct Templates {
    std::string page, entry, lesson, before, slider, difference, formula, charts, chart;
};

Templates read_templates(const fs::path& project) {
    Templates t;
    t.page = read_text(project / "framework/app/programs/gallery.html");
    t.lesson = take_section(t.page, "lesson");
    t.before = take_section(t.lesson, "before");
    t.slider = take_section(t.lesson, "slider");
    t.difference = take_section(t.lesson, "difference");
    t.formula = take_section(t.lesson, "formula");
    t.entry = take_section(t.page, "entry");
    t.charts = take_section(t.page, "charts");
    t.chart = take_section(t.charts, "chart");
    return t;
}

struct Lesson {
    std::string name, number, heading;
    std::string picture;  // as a data URI
    json statistics;

    std::string reference() const { return escape(number + " \u00b7 " + heading); }
};

json read_json(const fs::path& path) {
    json value = json::parse(read_text(path), nullptr, false);
    if (!value.is_object()) {
        throw Error(path.string() + ": is not a JSON object");
    }
    return value;
}

// What follows the dot in a README's first line, "# 9 \u00b7 Normalised Phong"; else the name.
std::string heading_of(const fs::path& folder) {
    const fs::path readme = folder / "README.md";
    const std::string text = fs::exists(readme) ? read_text(readme) : "";
    const std::string line = text.substr(0, text.find('\n'));
    const std::string dot = " \u00b7 ";
    const auto parting = line.find(dot);
    if (parting != std::string::npos) {
        return line.substr(parting + dot.size());
    }
    std::string words = folder.filename().string().substr(3);
    std::ranges::replace(words, '_', ' ');
    return words;
}

// NN_name
Lesson read_lesson(const fs::path& project, const fs::path& out, const std::string& name) {
    const auto digits = name.find_first_not_of("0123456789");
    if (digits != 2 || name[2] != '_' || name.size() < 4) {
        throw Error(name + ": is not a lesson's name, NN_name");
    }
    return {.name = name,
            .number = std::to_string(std::stoi(name)),
            .heading = heading_of(project / "lessons" / name),
            .picture = data_uri(out / (name + ".png"), "image/png"),
            .statistics = read_json(out / (name + ".json"))};
}

// ---- numbers

std::string rounded(double value, int digits) {
    char text[64];
    std::snprintf(text, sizeof text, "%.*f", digits, value);
    return text;
}

std::string metric(const json& numbers, const char* name, int digits, double factor = 1) {
    const json& value = numbers.at(name);
    return value.is_null() ? "\u221e" : rounded(factor * value.get<double>(), digits);
}

// 322054 as 322 054, with spaces that do not break.
std::string grouped(std::int64_t count) {
    std::string text = std::to_string(count);
    for (auto at = static_cast<std::ptrdiff_t>(text.size()) - 3; at > 0; at -= 3) {
        text.insert(static_cast<std::size_t>(at), "\u202f");
    }
    return text;
}

// The heat map's colours for its legend, as CSS wants them.
std::string gradient() {
    std::string colours;
    for (int i = 0; i <= 8; ++i) {
        const Rgba8 c = heat_colour(static_cast<float>(i) / 8);
        colours += std::string(i > 0 ? ", " : "") + "rgb(" + std::to_string(c.r) + " " +
                   std::to_string(c.g) + " " + std::to_string(c.b) + ")";
    }
    return colours;
}

// ---- parts of the page

std::string difference(const std::string& text, const fs::path& out, const Lesson& before,
                       const Lesson& lesson) {
    const std::string stem = before.name + "_to_" + lesson.name;
    const json numbers = read_json(out / (stem + ".json"));
    return fill(text, {{"number", lesson.number},
                       {"before_number", before.number},
                       {"heat", data_uri(out / (stem + ".heat.png"), "image/png")},
                       {"max", metric(numbers, "max", 0)},
                       {"rmse", metric(numbers, "rmse", 2)},
                       {"psnr", metric(numbers, "psnr", 2)},
                       {"ssim", metric(numbers, "ssim", 4)},
                       {"flip_mean", metric(numbers, "flip_mean", 4)},
                       {"flip_max", metric(numbers, "flip_max", 4)},
                       {"over_one", metric(numbers, "over_one", 1, 100)}});
}

std::string formula(const std::string& text, const fs::path& file) {
    return fs::exists(file) ? fill(text, {{"math", read_text(file)}}) : "";
}

// title "Lesson 9: what is drawn" without its first words.
std::string caption(const Lesson& lesson) {
    const auto title = lesson.statistics.at("title").get<std::string>();
    const std::string words = "Lesson " + lesson.number + ": ";
    return escape(title.starts_with(words) ? title.substr(words.size()) : title);
}

std::string section(const Templates& t, const fs::path& project, const fs::path& out,
                    const Lesson* before, const Lesson& lesson) {
    const json& s = lesson.statistics;
    const double ms = s.at("frame_ms_min");
    const std::int64_t fragments = s.at("fragments_shaded");
    const Values values{{"name", lesson.name},
                        {"number", lesson.number},
                        {"reference", lesson.reference()},
                        {"heading", escape(lesson.heading)},
                        {"caption", caption(lesson)},
                        {"picture", lesson.picture},
                        {"ms", rounded(ms, 1)},
                        {"ns", fragments > 0 ? rounded(1e6 * ms / double(fragments), 1) : "0"},
                        {"fragments", grouped(fragments)},
                        {"triangles", grouped(s.at("triangles_in"))},
                        {"before_number", before ? before->number : ""},
                        {"before_reference", before ? before->reference() : ""},
                        {"before_picture", before ? before->picture : ""}};
    Values parts = values;
    parts["before"] = before ? fill(t.before, values) : "";
    parts["slider"] = before ? fill(t.slider, values) : "";
    parts["difference"] = before ? difference(t.difference, out, *before, lesson) : "";
    parts["formula"] = formula(t.formula, project / "lessons" / lesson.name / "formula.mathml");
    return fill(t.lesson, parts);
}

std::string charts(const Templates& t, const fs::path& folder) {
    std::vector<fs::path> files;
    if (fs::is_directory(folder)) {
        for (const fs::path& file : fs::directory_iterator(folder)) {
            if (file.extension() == ".svg") {
                files.push_back(file);
            }
        }
    }
    std::ranges::sort(files);
    std::string all;
    for (const fs::path& file : files) {
        std::string words = file.stem().string();
        std::ranges::replace(words, '_', ' ');
        all +=
            fill(t.chart, {{"chart", data_uri(file, "image/svg+xml")}, {"words", escape(words)}});
    }
    return all.empty() ? "" : fill(t.charts, {{"chart", all}});
}

std::string page(const fs::path& project, const fs::path& out,
                 const std::vector<std::string>& names) {
    const Templates t = read_templates(project);
    std::vector<Lesson> lessons;
    std::string entries;
    std::string sections;
    for (const std::string& name : names) {
        lessons.push_back(read_lesson(project, out, name));
        const Lesson& lesson = lessons.back();
        entries +=
            fill(t.entry,
                 {{"name", name}, {"number", lesson.number}, {"heading", escape(lesson.heading)}});
        const Lesson* before = lessons.size() > 1 ? &lesson - 1 : nullptr;
        sections += section(t, project, out, before, lesson);
    }
    const json& s = lessons.front().statistics;
    return fill(t.page, {{"entry", entries},
                         {"lesson", sections},
                         {"charts", charts(t, project / "docs/charts/results")},
                         {"gradient", gradient()},
                         {"lanes", s.at("lanes").dump()},
                         {"threads", s.at("threads").dump()},
                         {"samples", s.at("samples").dump()},
                         {"frames", s.at("frames").dump()},
                         {"instruction_set", escape(s.at("instruction_set").get<std::string>())}});
}

void run(const std::vector<std::string>& words) {
    if (words.size() < 3) {
        throw Error("gallery wants PROJECT OUT LESSON...; lessons/run calls it so");
    }
    const fs::path out = words[1];
    const std::string text = page(words[0], out, {words.begin() + 2, words.end()});
    write_text(out / "index.html", text);
}

}  // namespace

int main(int argc, char** argv) {
    try {
        run({argv + 1, argv + argc});
        return 0;
    } catch (const std::exception& e) {
        std::fprintf(stderr, "error: %s\n", e.what());
        return 2;
    }
}
