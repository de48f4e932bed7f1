#include "tests/grading/case.hpp"

#include <nlohmann/json.hpp>

#include <cmath>

namespace glint::grading {

static void to_json(nlohmann::json& j, const Check::Term& t) {
    j = {t.answer, t.weight};
}
static void from_json(const nlohmann::json& j, Check::Term& t) {
    j.at(0).get_to(t.answer);
    j.at(1).get_to(t.weight);
}

// JSON has no word for what is no number: it writes null.
static void to_json(nlohmann::json& j, const Mistake& m) {
    j = {{"task", m.task}, {"words", m.words}, {"skeleton", m.skeleton}, {"answers", m.answers}};
}
static void from_json(const nlohmann::json& j, Mistake& m) {
    j.at("task").get_to(m.task);
    j.at("words").get_to(m.words);
    j.at("skeleton").get_to(m.skeleton);
    for (const nlohmann::json& a : j.at("answers")) {
        m.answers.push_back(a.is_null() ? std::nan("") : a.get<double>());
    }
}

// NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE names each member once, for reading and for writing.
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(Check, terms, low, high)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(Frame, width, height, pixels, light)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(Batch, number, columns, answers_a_row, questions, checks,
                                   mistakes, floor, frame)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(Case, name, kind, points, hidden, batches)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(Task, id, title, of, cases)

void to_json(nlohmann::json& j, const Lesson& lesson) {
    j = {{"name", lesson.name}, {"header", lesson.header}, {"tasks", lesson.tasks}};
}
void from_json(const nlohmann::json& j, Lesson& lesson) {
    j.at("name").get_to(lesson.name);
    j.at("header").get_to(lesson.header);
    j.at("tasks").get_to(lesson.tasks);
}

}  // namespace glint::grading
