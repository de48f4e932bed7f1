#include "tests/grading/report.hpp"

#include "tests/grading/plain_text.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <sstream>

namespace glint::grading {
namespace {

using nlohmann::json;

json to_json(const Failure& f) {
    return {{"number", f.number}, {"question", f.question}, {"component", f.component},
            {"low", f.low},       {"high", f.high},         {"got", f.got}};
}

json to_json(const CaseResult& c) {
    json j{{"name", c.name},     {"kind", c.kind},      {"hidden", c.hidden},
           {"points", c.points}, {"earned", c.earned},  {"verdict", name_of(c.verdict)},
           {"words", c.words},   {"seconds", c.seconds}};
    if (c.failure) {
        j["failure"] = to_json(*c.failure);
    }
    return j;
}

json to_json(const TaskResult& t) {
    json j{{"id", t.id},           {"title", t.title},         {"points", t.points()},
           {"earned", t.earned()}, {"diagnosis", t.diagnosis}, {"cases", json::array()}};
    for (const CaseResult& c : t.cases) {
        j["cases"].push_back(to_json(c));
    }
    return j;
}

json to_json(const LessonResult& l) {
    json j{{"lesson", l.lesson},   {"verdict", name_of(l.verdict)}, {"words", l.words},
           {"points", l.points()}, {"earned", l.earned()},          {"tasks", json::array()}};
    for (const TaskResult& t : l.tasks) {
        j["tasks"].push_back(to_json(t));
    }
    return j;
}

std::string number(double x) {
    std::ostringstream text;
    text.precision(7);
    text << x;
    return text.str();
}

std::string joined(const std::vector<double>& numbers) {
    std::string text;
    for (const double x : numbers) {
        text += (text.empty() ? "" : ", ") + number(x);
    }
    return text;
}

// A question's numbers by their names: N = (0, 0, 1), n = 32.
std::string named(const Failure& f) {
    std::istringstream names(f.of);
    std::string text;
    auto at = f.question.begin();
    for (std::string name; names >> name;) {
        const std::size_t bracket = name.find('[');
        const bool is_vector = bracket != std::string::npos;
        const auto end = at + (is_vector ? name.at(bracket + 1) - '0' : 1);
        const std::string value = joined({at, end});
        text += (text.empty() ? "" : ", ") + name.substr(0, bracket) + " = " +
                (is_vector ? "(" + value + ")" : value);
        at = end;
    }
    return text;
}

// Bounds as a value where they are those of one.
std::string wanted(const Failure& f) {
    const double middle = (f.low + f.high) / 2;
    return f.high - f.low <= 1e-3 * std::max(1.0, std::abs(middle))
               ? number(std::abs(middle) < f.high - f.low ? 0 : middle)
               : number(f.low) + " to " + number(f.high);
}

void line(std::ostream& out, const std::string& text, double earned, double points) {
    const std::size_t width = 72;
    const std::string score = points_text(earned) + " of " + points_text(points);
    const std::size_t used = text.size() + score.size();
    out << text << std::string(used < width ? width - used : 1, ' ') << score << '\n';
}

void print_task(std::ostream& out, const TaskResult& t) {
    line(out, "  " + t.id + "  " + t.title, t.earned(), t.points());
    if (t.earned() == t.points()) {
        return;
    }
    if (t.diagnosis == "the skeleton") {
        out << "        not begun: these are the skeleton's values\n";
        return;
    }
    if (!t.diagnosis.empty()) {
        out << "        your values are those of " << t.diagnosis << '\n';
    }
    const auto first = std::find_if(t.cases.begin(), t.cases.end(),
                                    [](const CaseResult& c) { return !explain(c).empty(); });
    if (first != t.cases.end()) {
        out << "        " << explain(*first) << '\n';
        if (first->shown) {
            out << first->shown->raster;
        }
    }
}

bool has_hidden_cases(const TaskResult& t) {
    return std::any_of(t.cases.begin(), t.cases.end(),
                       [](const CaseResult& c) { return c.hidden; });
}

void print_lesson(std::ostream& out, const LessonResult& l) {
    line(out, l.lesson, l.earned(), l.points());
    if (l.verdict != Verdict::ok && !l.words.empty()) {
        out << "  " << name_of(l.verdict) << ": " << l.words
            << (l.words.ends_with('\n') ? "" : "\n");
        return;
    }
    for (const TaskResult& t : l.tasks) {
        print_task(out, t);
    }
    if (std::none_of(l.tasks.begin(), l.tasks.end(), has_hidden_cases)) {
        out << "  visible cases only: hidden ones bring the lesson's other points\n";
    }
    if (l.earned() < l.points()) {
        out << "  to read: lessons/" << l.lesson << "/README.md\n";
    }
}

double sum(const std::vector<LessonResult>& lessons, double (LessonResult::*of)() const) {
    return std::accumulate(lessons.begin(), lessons.end(), 0.0,
                           [&](double s, const LessonResult& l) { return s + (l.*of)(); });
}

}  // namespace

double Report::points() const {
    return sum(lessons, &LessonResult::points);
}
double Report::earned() const {
    return sum(lessons, &LessonResult::earned);
}
bool Report::is_final() const {
    return std::none_of(lessons.begin(), lessons.end(),
                        [](const LessonResult& l) { return l.verdict == Verdict::internal_error; });
}

json to_json(const Report& r) {
    json j{{"schema", report_schema},    {"student", r.student}, {"assignment", r.assignment},
           {"submission", r.submission}, {"bundle", r.bundle},   {"seed", r.seed},
           {"points", r.points()},       {"earned", r.earned()}, {"final", r.is_final()},
           {"lessons", json::array()}};
    for (const LessonResult& l : r.lessons) {
        j["lessons"].push_back(to_json(l));
    }
    return j;
}

std::string explain(const CaseResult& c) {
    if (c.verdict == Verdict::ok) {
        return "";
    }
    if (c.hidden) {
        return "hidden cases ask for other values, the ends of the ranges too";
    }
    if (!c.failure) {
        const std::string verdict(c.verdict == Verdict::wrong ? "" : name_of(c.verdict));
        const bool both = !verdict.empty() && !c.words.empty();
        return c.name + ": " + verdict + (both ? ", " : "") + c.words;
    }
    const Failure& f = *c.failure;
    if (c.kind == "albedo") {
        return c.name + ": the integral is " + number(f.got) + ", it is to be " + wanted(f);
    }
    const std::string place = f.place.empty() ? "" : f.place + ", ";
    return c.name + ": " + place + "for " + named(f) + ", as " + f.number + ", you make " +
           (c.kind == "reciprocity" ? "a difference of " : "") + number(f.got) + ", it is to be " +
           wanted(f);
}

std::string points_text(double points) {
    std::ostringstream text;
    text << std::round(points * 100) / 100;
    return text.str();
}

void print(std::ostream& out, const Report& r) {
    for (const LessonResult& l : r.lessons) {
        print_lesson(out, l);
    }
    if (r.lessons.size() > 1) {
        line(out, "all", r.earned(), r.points());
    }
}

}  // namespace glint::grading
