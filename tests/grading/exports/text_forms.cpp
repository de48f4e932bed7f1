#include "tests/grading/exports/exports.hpp"
#include "tests/grading/exports/words.hpp"

#include <sstream>

namespace glint::grading {
namespace {

std::string replaced(std::string text, const std::string& what, const std::string& by) {
    for (std::size_t at = 0; (at = text.find(what, at)) != std::string::npos; at += by.size()) {
        text.replace(at, what.size(), by);
    }
    return text;
}

// In a table of Markdown: no markup of the text's own.
std::string in_markdown(const std::string& text) {
    return replaced(replaced(escaped(text), "|", "\\|"), "\n", "<br>");
}

// The commands of GitHub Actions end with their line.
std::string in_command(const std::string& text) {
    return replaced(replaced(replaced(text, "%", "%25"), "\r", "%0D"), "\n", "%0A");
}

// Spreadsheets compute what starts with these.
std::string in_csv(const std::string& text) {
    const bool formula =
        !text.empty() && std::string("=+-@\t").find(text.front()) != std::string::npos;
    return '"' + std::string(formula ? "'" : "") + replaced(text, "\"", "\"\"") + '"';
}

}  // namespace

std::string escaped(const std::string& text) {
    return replaced(
        replaced(replaced(replaced(replaced(text, "&", "&amp;"), "<", "&lt;"), ">", "&gt;"), "\"",
                 "&quot;"),
        "'", "&#39;");
}

std::string as_github(const Report& report) {
    std::ostringstream out;
    out << "| task | points | of | |\n|---|---|---|---|\n";
    for (const LessonResult& lesson : report.lessons) {
        for (const TaskResult& task : lesson.tasks) {
            std::string words;
            for (const CaseResult& c : task.cases) {
                words = words.empty() ? words_for(lesson, task, c) : words;
            }
            out << "| " << task.id << ' ' << in_markdown(task.title) << " | "
                << points_text(task.earned()) << " | " << points_text(task.points()) << " | "
                << in_markdown(words) << " |\n";
        }
    }
    out << "| all | " << points_text(report.earned()) << " | " << points_text(report.points())
        << " | |\n";
    return out.str();
}

std::string github_annotations(const Report& report) {
    std::ostringstream out;
    for (const LessonResult& lesson : report.lessons) {
        for (const TaskResult& task : lesson.tasks) {
            for (const CaseResult& c : task.cases) {
                const std::string words = words_for(lesson, task, c);
                if (!words.empty()) {
                    out << "::error file=lessons/" << lesson.lesson << "/README.md,title=Task "
                        << task.id << "::" << in_command(words) << '\n';
                    break;
                }
            }
        }
    }
    return out.str();
}

std::string csv_head(const Report& report) {
    std::string head = "student,points,of,final";
    for (const LessonResult& lesson : report.lessons) {
        for (const TaskResult& task : lesson.tasks) {
            head += ',' + task.id;
        }
        head += ',' + lesson.lesson.substr(0, 2) + " verdict";
    }
    return head + ",seconds,submission,bundle,seed\n";
}

std::string as_csv(const Report& report) {
    std::string row = in_csv(report.student) + ',' + points_text(report.earned()) + ',' +
                      points_text(report.points()) + ',' + (report.is_final() ? "yes" : "no");
    double seconds = 0;
    for (const LessonResult& lesson : report.lessons) {
        for (const TaskResult& task : lesson.tasks) {
            row += ',' + points_text(task.earned());
            for (const CaseResult& c : task.cases) {
                seconds += c.seconds;
            }
        }
        row += ',' + std::string(name_of(lesson.verdict));
    }
    return row + ',' + points_text(seconds) + ',' + report.submission + ',' + report.bundle + ',' +
           report.seed + '\n';
}

}  // namespace glint::grading
