#include "framework/image/file.hpp"
#include "tests/grading/cases.hpp"
#include "tests/grading/digest.hpp"
#include "tests/grading/instructor/make_batch.hpp"

#include <nlohmann/json.hpp>

namespace glint::grading {
namespace {

using nlohmann::json;

// Visible cases follow from a secret that is none.
const Identity everyone{"visible", "", ""};

Case make_case(const json& task, const json& asked, std::span<const Variant> variants,
               const Identity& who, bool lanes) {
    const std::string id = task.at("id");
    const std::string name = asked.at("name");
    const bool hidden = asked.value("hidden", false);
    const std::string text = who.assignment + '\n' + who.student + '\n' + id + '\n' + name;
    const Wanted wanted{task, asked, variants, seed(who.secret, text)};
    Case c{name, asked.at("kind"), asked.at("points"), hidden, {}};
    const json usual = asked.at("kind") == "picture" ? json{"float"}
                       : lanes                       ? json{"float", "lanes", "double"}
                                                     : json{"float", "double"};
    for (const std::string number : task.value("numbers", usual)) {
        c.batches.push_back(make_batch(wanted, number));
    }
    return c;
}

}  // namespace

Lesson cases_of(const std::string& name, const std::optional<Identity>& identity) {
    const json manifest = json::parse(read_text(lesson_file(name)));
    Lesson lesson{manifest.at("lesson"), manifest.at("header"), {}};
    for (const json& task : manifest.at("tasks")) {
        lesson.tasks.push_back({task.at("id"), task.at("title"), {}});
        for (const json& asked : task.at("cases")) {
            const bool hidden = asked.value("hidden", false);
            if (!hidden || identity) {
                lesson.tasks.back().cases.push_back(make_case(task, asked, variants_of(name),
                                                              hidden ? identity.value() : everyone,
                                                              manifest.value("lanes", false)));
            }
        }
    }
    return lesson;
}

}  // namespace glint::grading
