#include "tests/grading/exports/exports.hpp"
#include "tests/grading/exports/pictures.hpp"
#include "tests/grading/exports/words.hpp"

#include <sstream>

namespace glint::grading {
namespace {

constexpr const char* style =
    "body{font:16px sans-serif;max-width:60rem;margin:2rem auto;padding:0 1rem}"
    "table{border-collapse:collapse;width:100%}td,th{border:1px solid #bbb;padding:.3rem .6rem;"
    "text-align:left;vertical-align:top}pre{white-space:pre-wrap;margin:0}"
    "img{width:32rem;image-rendering:pixelated;margin:.3rem "
    "0}.ok{background:#e3f4e3}.wrong{background:#fbe6e3}";

std::string image_of(const CaseResult& c) {
    return has_picture(c) ? "<img src=\"" + picture_url(c) + "\" alt=\"" + picture_parts +
                                "\" title=\"" + picture_parts + "\">"
                          : "";
}

}  // namespace

std::string as_html(const Report& report) {
    std::ostringstream out;
    out << "<!DOCTYPE html>\n<html lang=\"en\"><head><meta charset=\"utf-8\"><title>"
        << escaped(report.student) << "</title><style>" << style << "</style></head><body>\n<h1>"
        << points_text(report.earned()) << " of " << points_text(report.points())
        << " points</h1>\n<p>" << escaped(report.student) << ' ' << escaped(report.assignment)
        << "</p>\n";
    for (const LessonResult& lesson : report.lessons) {
        out << "<h2>" << escaped(lesson.lesson) << "</h2>\n<table><tr><th>task</th><th>case</th>"
            << "<th>points</th><th></th></tr>\n";
        for (const TaskResult& task : lesson.tasks) {
            for (const CaseResult& c : task.cases) {
                out << "<tr class=\"" << (c.verdict == Verdict::ok ? "ok" : "wrong") << "\"><td>"
                    << task.id << ' ' << escaped(task.title) << "</td><td>" << escaped(c.name)
                    << "</td><td>" << points_text(c.earned) << " of " << points_text(c.points)
                    << "</td><td><pre>" << escaped(words_for(lesson, task, c))
                    << (raster_of(c).empty() ? "" : '\n' + raster_of(c)) << "</pre>" << image_of(c)
                    << "</td></tr>\n";
            }
        }
        out << "</table>\n";
    }
    out << "</body></html>\n";
    return out.str();
}

}  // namespace glint::grading
