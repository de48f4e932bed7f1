#include "framework/image/file.hpp"
#include "framework/math/error.hpp"
#include "tests/grading/cases.hpp"
#include "tests/grading/digest.hpp"
#include "tests/grading/instructor/make_batch.hpp"

#include <nlohmann/json.hpp>

#include <sstream>

namespace glint::grading {
namespace {

using nlohmann::json;

// Visible cases follow from a secret that is none.
const Identity everyone{"visible", "", ""};

// How many numbers names like "N[3] n" stand for.
std::size_t columns_of(const std::string& names) {
    std::istringstream words(names);
    std::size_t columns = 0;
    for (std::string name; words >> name;) {
        const std::size_t bracket = name.find('[');
        columns += bracket == std::string::npos ? 1 : std::stoul(name.substr(bracket + 1));
    }
    return columns;
}

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
        if (c.batches.back().columns != columns_of(task.at("of"))) {
            throw Error(id + ": \"of\" does not name the numbers of " + name);
        }
    }
    return c;
}

}  // namespace

Lesson cases_of(const std::string& name, const std::optional<Identity>& identity) {
    const json manifest = json::parse(read_text(lesson_file(name)));
    Lesson lesson{manifest.at("lesson"), manifest.at("header"), {}};
    for (const json& task : manifest.at("tasks")) {
        lesson.tasks.push_back({task.at("id"), task.at("title"), task.at("of"), {}});
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
