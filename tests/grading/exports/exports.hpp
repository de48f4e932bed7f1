// A report in the forms that others read. Students may see all of it: of hidden cases there is
// nothing but the points and a fixed hint.
#pragma once

#include "tests/grading/report.hpp"

#include <string>

namespace glint::grading {

std::string as_gradescope(const Report& report);    // results.json
std::string as_prairielearn(const Report& report);  // results.json, score 0..1
std::string as_autolab(const Report& report);       // the last line of the autograder's output
std::string as_junit(const Report& report);         // XML
std::string as_github(const Report& report);        // job summary, Markdown
std::string as_html(const Report& report);          // a page by itself

// Lines that GitHub Actions shows at the student's files.
std::string github_annotations(const Report& report);

// A line of grades.csv, and the line above them all.
std::string as_csv(const Report& report);
std::string csv_head(const Report& report);

// & < > " ' as XML and HTML write them.
std::string escaped(const std::string& text);

}  // namespace glint::grading
