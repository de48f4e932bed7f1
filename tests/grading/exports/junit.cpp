#include "tests/grading/exports/exports.hpp"
#include "tests/grading/exports/words.hpp"

#include <sstream>

namespace glint::grading {
namespace {

struct Counts {
    int tests = 0, failures = 0, errors = 0, skipped = 0;
};

bool is_skipped(const CaseResult& c) {
    return c.verdict == Verdict::skipped;
}

// How an answer to a hidden case fails would tell what it asks for.
bool is_error(const CaseResult& c) {
    const bool answered = c.verdict == Verdict::ok || c.verdict == Verdict::wrong;
    return c.verdict == Verdict::internal_error || (!c.hidden && !answered && !is_skipped(c));
}

std::string counts_of(const LessonResult& lesson) {
    Counts n;
    for (const TaskResult& task : lesson.tasks) {
        for (const CaseResult& c : task.cases) {
            ++n.tests;
            const bool failed = c.verdict != Verdict::ok;
            n.skipped += is_skipped(c) ? 1 : 0;
            n.errors += is_error(c) ? 1 : 0;
            n.failures += failed && !is_skipped(c) && !is_error(c) ? 1 : 0;
        }
    }
    std::ostringstream text;
    text << "tests=\"" << n.tests << "\" failures=\"" << n.failures << "\" errors=\"" << n.errors
         << "\" skipped=\"" << n.skipped << '"';
    return text.str();
}

void write_case(std::ostream& out, const LessonResult& lesson, const TaskResult& task,
                const CaseResult& c) {
    out << R"(    <testcase classname=")" << escaped(lesson.lesson) << '.' << task.id
        << R"(" name=")" << escaped(c.name) << R"(" time=")" << (c.hidden ? 0 : c.seconds)
        << "\">\n"
        << R"(      <properties><property name="points" value=")" << points_text(c.earned)
        << R"("/><property name="max_points" value=")" << points_text(c.points)
        << "\"/></properties>\n";
    if (c.verdict != Verdict::ok) {
        const std::string tag = is_skipped(c) ? "skipped" : is_error(c) ? "error" : "failure";
        out << "      <" << tag << " message=\""
            << (tag == "failure" ? "wrong" : name_of(c.verdict)) << "\">"
            << escaped(words_for(lesson, task, c)) << "</" << tag << ">\n";
    }
    out << "    </testcase>\n";
}

}  // namespace

std::string as_junit(const Report& report) {
    std::ostringstream out;
    out << "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<testsuites>\n";
    for (const LessonResult& lesson : report.lessons) {
        out << "  <testsuite name=\"" << escaped(lesson.lesson) << "\" " << counts_of(lesson)
            << ">\n";
        for (const TaskResult& task : lesson.tasks) {
            for (const CaseResult& c : task.cases) {
                write_case(out, lesson, task, c);
            }
        }
        out << "  </testsuite>\n";
    }
    out << "</testsuites>\n";
    return out.str();
}

}  // namespace glint::grading
