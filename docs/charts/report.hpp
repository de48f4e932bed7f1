// What was measured, as a file and as a table in a text.
#pragma once

#include "docs/charts/harness.hpp"

#include <string_view>

namespace glint::charts {

// A line of names, then a line a row.
std::string csv(const Family& family, const std::vector<Row>& rows);

// In Markdown: a line a method, a column a task, "ns / error" in each; bold on the front.
std::string table(const Family& family, const std::vector<Row>& rows);

// The text with what is between "<!-- begin table NAME -->" and "<!-- end table NAME -->" replaced.
// Error where it has no such marks.
std::string with_table(std::string text, std::string_view name, std::string_view table);

}  // namespace glint::charts
