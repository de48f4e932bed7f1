#include "docs/charts/report.hpp"

#include "framework/math/error.hpp"

#include <algorithm>
#include <cstdio>
#include <map>
#include <sstream>

namespace glint::charts {
namespace {

std::string digits(double value, int count) {
    char text[32];
    std::snprintf(text, sizeof text, "%.*g", count, value);
    return text;
}

void add_once(std::vector<std::string>& all, const std::string& one) {
    if (std::find(all.begin(), all.end(), one) == all.end()) {
        all.push_back(one);
    }
}

std::string task_of(const Row& row) {
    return row.judgement.variant + ", " + row.judgement.unit;
}

std::string cell(const Row& row) {
    const std::string numbers = digits(row.ns, 3) + " / " + digits(row.error, 2);
    return row.on_front ? "**" + numbers + "**" : numbers;
}

// How far the quartiles are from the median, in percent of it; the median of all rows.
double usual_spread(const std::vector<Row>& rows) {
    std::vector<double> spread;
    spread.reserve(rows.size());
    for (const Row& row : rows) {
        spread.push_back(100 * std::max(row.ns_high - row.ns, row.ns - row.ns_low) / row.ns);
    }
    std::sort(spread.begin(), spread.end());
    return spread.empty() ? 0 : spread[spread.size() / 2];
}

}  // namespace

std::string csv(const Family& family, const std::vector<Row>& rows) {
    std::ostringstream out;
    out << "method,variant,per,ns,ns_low,ns_high,max_error,rms_error,unit,judged_by,on_front\n";
    for (const Row& r : rows) {
        const Judgement& j = r.judgement;
        out << r.method << ',' << j.variant << ',' << family.per << ',' << digits(r.ns, 5) << ','
            << digits(r.ns_low, 5) << ',' << digits(r.ns_high, 5) << ','
            << digits(j.errors.largest, 5) << ',' << digits(j.errors.rms, 5) << ',' << j.unit << ','
            << (family.judged_by == JudgedBy::largest ? "max" : "rms") << ',' << r.on_front << '\n';
    }
    return out.str();
}

std::string table(const Family& family, const std::vector<Row>& rows) {
    std::vector<std::string> methods;
    std::vector<std::string> tasks;
    std::map<std::pair<std::string, std::string>, std::string> cells;
    for (const Row& row : rows) {
        add_once(methods, row.method);
        add_once(tasks, task_of(row));
        cells[{row.method, task_of(row)}] = cell(row);
    }
    std::ostringstream out;
    out << "| method |";
    for (const std::string& task : tasks) {
        out << ' ' << task << " |";
    }
    out << "\n|---|";
    for (std::size_t i = 0; i < tasks.size(); ++i) {
        out << "---|";
    }
    for (const std::string& method : methods) {
        out << "\n| " << method << " |";
        for (const std::string& task : tasks) {
            out << ' ' << cells[{method, task}] << " |";
        }
    }
    out << "\n\nns a" << (family.per.find_first_of("aeiou") == 0 ? "n " : " ") << family.per
        << " / " << (family.judged_by == JudgedBy::largest ? "largest" : "RMS")
        << " error, in the unit that the column names; **on the front**. Half of the times lie "
           "within "
        << digits(usual_spread(rows), 2) << " % of the median, typically.\n";
    return out.str();
}

std::string with_table(std::string text, std::string_view name, std::string_view table) {
    const std::string begin = "<!-- begin table " + std::string(name) + " -->\n";
    const std::string end = "<!-- end table " + std::string(name) + " -->";
    const std::size_t from = text.find(begin);
    const std::size_t to = text.find(end);
    if (from == std::string::npos || to == std::string::npos || to < from) {
        throw Error("the document has no marks for the table " + std::string(name));
    }
    return text.replace(from + begin.size(), to - from - begin.size(), table);
}

}  // namespace glint::charts
