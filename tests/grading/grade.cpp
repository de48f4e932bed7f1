// grade: what a submission is worth.
#include "framework/math/error.hpp"
#include "tests/grading/cases.hpp"
#include "tests/grading/digest.hpp"
#include "tests/grading/doctor.hpp"
#include "tests/grading/grade_lesson.hpp"
#include "tests/grading/report.hpp"
#include "tests/grading/text_file.hpp"

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include <csignal>
#include <iostream>
#include <sys/prctl.h>
#include <sys/stat.h>

namespace {

using namespace glint::grading;
using glint::Error;

struct Options {
    std::vector<std::string> lessons;  // numbers or names; none: all that were handed in
    std::filesystem::path submission = SOURCE_FOLDER;
    std::filesystem::path secret, out;
    std::string student, assignment = "course";
};

std::string lesson_of(const std::string& word) {
    for (const std::string& name : graded_lessons()) {
        if (name == word || name.substr(0, 2) == word || name.substr(0, 2) == '0' + word) {
            return name;
        }
    }
    throw Error("lesson " + word + " is not graded");
}

std::optional<Identity> identity_of(const Options& o) {
    if (o.secret.empty()) {
        return std::nullopt;
    }
    if (!is_protected(protections())) {
        throw Error("hidden cases are not run on this machine; grade doctor says what is missing");
    }
    const std::string secret = read_text(o.secret);
    if (secret.size() < 16) {
        throw Error(o.secret.string() + ": a secret has 16 bytes or more");
    }
    return Identity{secret, o.assignment, o.student};
}

Report grade(const Options& o) {
    const auto identity = identity_of(o);
    Report report{o.student, o.assignment, "", "", {}};
    std::string all;
    for (const std::string& name : graded_lessons()) {
        const bool named = std::any_of(o.lessons.begin(), o.lessons.end(),
                                       [&](const auto& word) { return lesson_of(word) == name; });
        const Lesson lesson = cases_of(name, identity);
        const Intake submitted = find_header(o.submission, lesson);
        const bool there = submitted.text || !submitted.objection.empty();
        if (named || (o.lessons.empty() && there)) {
            report.lessons.push_back(grade_lesson(lesson, submitted, SOURCE_FOLDER));
            all += submitted.text.value_or("") + '\0';
        }
    }
    if (report.lessons.empty()) {
        throw Error(o.submission.string() + ": no lesson's header is there");
    }
    report.submission = sha256(all);
    return report;
}

int one(const Options& o) {
    const Report report = grade(o);
    print(std::cout, report);
    if (!o.out.empty()) {
        std::filesystem::create_directories(o.out);
        write_text(o.out / "report.json", to_json(report).dump(1) + '\n');
    }
    return report.is_final() ? 0 : 3;
}

int doctor() {
    const auto all = protections();
    for (const Protection& p : all) {
        std::cout << (p.there ? "  yes  " : "  no   ") << p.name << ": " << p.state << '\n';
    }
    std::cout << (is_protected(all) ? "Hidden cases are run here.\n"
                                    : "Practice, not a grade: hidden cases are not run here.\n");
    return is_protected(all) ? 0 : 1;
}

}  // namespace

int main(int argc, char** argv) {
    prctl(PR_SET_DUMPABLE, 0);  // nobody of this user reads this process's memory
    umask(022);
    Options o;
    CLI::App app("Grades what students hand in");
    app.require_subcommand(1);
    CLI::App* one_command = app.add_subcommand("one", "Grades a header, or a folder with some");
    one_command->add_option("submission", o.submission, "file or folder; this tree if left out");
    one_command->add_option("--lesson", o.lessons, "numbers; those that are there if left out");
    one_command->add_option("--secret", o.secret, "a file; hidden cases are run with it");
    one_command->add_option("--student", o.student, "whose hidden cases");
    one_command->add_option("--assignment", o.assignment, "which hidden cases");
    one_command->add_option("--out", o.out, "folder for report.json");
    app.add_subcommand("doctor", "Says which protections this machine has");
    CLI11_PARSE(app, argc, argv);
    try {
        return one_command->parsed() ? one(o) : doctor();
    } catch (const std::exception& e) {
        std::cerr << "error: " << e.what() << '\n';
        return 2;
    }
}
