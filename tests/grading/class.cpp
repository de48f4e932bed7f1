#include "tests/grading/class.hpp"

#include "framework/image/file.hpp"
#include "framework/math/error.hpp"
#include "tests/grading/exports/exports.hpp"
#include "tests/grading/plain_text.hpp"
#include "tests/grading/scratch.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <chrono>
#include <iostream>
#include <map>
#include <set>
#include <sstream>
#include <sys/wait.h>
#include <unistd.h>

namespace glint::grading {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

json stored_report(const fs::path& folder) {
    try {
        return json::parse(read_text(folder / "report.json"));
    } catch (const std::exception&) {
        return {};
    }
}

bool is_still_true(const json& report, const fs::path& submission, const Order& order,
                   const std::string& bundle) {
    return report.is_object() && report.value("schema", 0) == report_schema &&
           report.value("final", false) && report.value("bundle", "") == bundle &&
           report.value("assignment", "") == order.assignment &&
           report.value("seed", "") == seed_of(order) &&
           report.value("submission", "") == submission_hash(submission, order);
}

void grade_student(const ClassOrder& c, const Student& s, const std::string& bundle) {
    const fs::path folder = c.out / s.name;
    Order order = c.order;
    order.student = s.name;
    if (!is_still_true(stored_report(folder), s.submission, order, bundle)) {
        fs::remove(folder / "report.json");  // else a grade that fails would leave the old one
        const Report report = grade_submission(s.submission, order);
        fs::create_directories(folder);
        write_text(folder / "report.html", as_html(report));
        write_text(folder / "grades.csv", csv_head(report) + as_csv(report));
        write_text(folder / "report.json", to_json(report).dump(1) + '\n');
    }
}

void say_progress(std::size_t done, std::size_t all, std::chrono::steady_clock::time_point start) {
    using std::chrono::duration;
    const double passed = duration<double>(std::chrono::steady_clock::now() - start).count();
    const double left = passed / static_cast<double>(done) * static_cast<double>(all - done);
    std::clog << '\r' << done << " of " << all << ", " << static_cast<int>(left / 60) << " min "
              << static_cast<int>(left) % 60 << " s left  " << (done == all ? "\n" : "")
              << std::flush;
}

pid_t start_grading(const ClassOrder& c, const Student& s, const std::string& bundle) {
    const pid_t self = getpid();
    const pid_t child = fork();
    if (child < 0) {
        throw Error("no more processes can be started");
    }
    if (child == 0) {
        end_with(self);
        try {
            grade_student(c, s, bundle);
        } catch (const std::exception& e) {
            std::clog << '\n' << printable(s.name, 80) << ": " << e.what() << '\n';
            _exit(1);
        }
        _exit(0);
    }
    return child;
}

// Each in a process of its own; returns whose did not come to its end.
std::set<std::string> grade_all(const ClassOrder& c, const std::vector<Student>& students) {
    const std::string bundle = bundle_hash();
    const auto start = std::chrono::steady_clock::now();
    std::map<pid_t, std::string> running;
    std::set<std::string> failed;
    std::size_t done = 0;
    const auto wait_for_one = [&] {
        int status = 0;
        const auto ended = running.extract(wait(&status));
        if (status != 0) {
            failed.insert(ended.mapped());
        }
        say_progress(++done, students.size(), start);
    };
    for (const Student& s : students) {
        if (running.size() == static_cast<std::size_t>(c.jobs)) {
            wait_for_one();
        }
        running.emplace(start_grading(c, s, bundle), s.name);
    }
    while (!running.empty()) {
        wait_for_one();
    }
    return failed;
}

struct Statistic {
    double points = 0, earned = 0;
    int count = 0, full = 0;
};

void add_to(std::map<std::string, Statistic>& all, const json& report) {
    for (const json& lesson : report.at("lessons")) {
        for (const json& task : lesson.at("tasks")) {
            for (const json& c : task.at("cases")) {
                Statistic& s = all[task.at("id").get<std::string>() + ",\"" +
                                   c.at("name").get<std::string>() + '"'];
                s.points += c.at("points").get<double>();
                s.earned += c.at("earned").get<double>();
                s.full += c.at("earned") == c.at("points") ? 1 : 0;
                ++s.count;
            }
        }
    }
}

// A case that nobody passes is likelier bad than all students are.
std::string statistics_csv(const std::map<std::string, Statistic>& all) {
    std::ostringstream out;
    out << "task,case,students,passed,mean share,note\n";
    for (const auto& [name, s] : all) {
        out << name << ',' << s.count << ',' << s.full << ',' << points_text(s.earned / s.points)
            << (s.full == 0 ? ",nobody passes: look at the case" : ",") << '\n';
    }
    return out.str();
}

std::string second_line(const std::string& text) {
    return text.substr(std::min(text.find('\n'), text.size() - 1) + 1);
}

}  // namespace

std::set<std::string> grade_class(const ClassOrder& given) {
    ClassOrder c = given;
    if (c.order.lessons.empty()) {
        c.order.lessons = graded_lessons();
    }
    const std::vector<Student> all = students_of(c.folder, c.roster);
    std::vector<Student> mine;
    for (std::size_t i = 0; i < all.size(); ++i) {
        if (static_cast<int>(i) % c.parts == c.part) {
            mine.push_back(all[i]);
        }
    }
    fs::create_directories(c.out);
    return grade_all(c, mine);
}

std::set<std::string> sum_up(const ClassOrder& c) {
    std::string grades;
    std::map<std::string, Statistic> statistics;
    std::set<std::string> not_final;
    for (const Student& s : students_of(c.folder, c.roster)) {
        const json report = stored_report(c.out / s.name);
        if (!report.is_object() || !report.value("final", false)) {
            not_final.insert(s.name);
        }
        if (report.is_object()) {
            const std::string rows = read_text(c.out / s.name / "grades.csv");
            grades += grades.empty() ? rows : second_line(rows);
            add_to(statistics, report);
        }
    }
    write_text(c.out / "grades.csv", grades);
    write_text(c.out / "statistics.csv", statistics_csv(statistics));
    return not_final;
}

}  // namespace glint::grading
