#include "tests/grading/grade_options.hpp"

#include "framework/image/file.hpp"
#include "framework/math/error.hpp"
#include "tests/grading/exports/exports.hpp"

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include <iostream>
#include <set>

namespace glint::grading {

const std::map<std::string, Form> forms{
    {"json", [](const Report& r) { return to_json(r).dump(1) + '\n'; }},
    {"html", as_html},
    {"junit", as_junit},
    {"gradescope", as_gradescope},
    {"prairielearn", as_prairielearn},
    {"autolab", as_autolab},
    {"github", as_github},
    {"annotations", github_annotations},
    {"csv", [](const Report& r) { return csv_head(r) + as_csv(r); }},
};

namespace {

void add_common(CLI::App& command, Options& o) {
    command.add_option("--lesson", o.lessons, "numbers or names; all if left out");
    command.add_option("--secret", o.secret, "a file; hidden cases are run with it");
    command.add_option("--assignment", o.c.order.assignment, "hidden cases differ by its name");
}

void add_class(CLI::App& command, Options& o) {
    command.add_option("folder", o.c.folder, "a folder or archive for each student")
        ->required()
        ->check(CLI::ExistingDirectory);
    command.add_option("--out", o.c.out, "folder for what is written")->required();
    command.add_option("--roster", o.c.roster,
                       "CSV, the first column (heading: student, or none) names students");
}

// Gradescope's submission_metadata.json: a group is one student.
std::string student_of(const std::filesystem::path& metadata) {
    std::set<std::string> ids;
    try {
        for (const nlohmann::json& user : nlohmann::json::parse(read_text(metadata)).at("users")) {
            ids.insert(user.at("id").dump());
        }
    } catch (const nlohmann::json::exception& e) {
        throw Error("--metadata " + metadata.string() +
                    ": is no submission_metadata.json of Gradescope's: " + e.what());
    }
    std::string all;
    for (const std::string& id : ids) {
        all += (all.empty() ? "" : ",") + id;
    }
    return all;
}

void finish(Options& o) {
    o.c.order.root = SOURCE_FOLDER;
    if (!o.metadata.empty()) {
        o.c.order.student = student_of(o.metadata);
    }
    if (!o.c.folder.empty()) {
        require_outside(o.c.folder, o.c.out);
    }
    for (const std::string& word : o.lessons) {
        o.c.order.lessons.push_back(lesson_named(word));
    }
    if (!o.secret.empty()) {
        o.c.order.secret = read_secret(o.secret);
    }
    char rest = 0;
    if (!o.part.empty() &&
        (std::sscanf(o.part.c_str(), "%d/%d%c", &o.c.part, &o.c.parts, &rest) != 2 ||
         o.c.part < 0 || o.c.part >= o.c.parts)) {
        throw Error("--part " + o.part + ": write 0/4 for the first of four");
    }
}

void declare_one(CLI::App& app, Options& o) {
    CLI::App* one = app.add_subcommand("one", "Grades a header, or a folder with some");
    one->add_option("submission", o.submission,
                    "file, folder or zip archive; this tree if left out");
    one->add_option("--student", o.c.order.student, "whose hidden cases");
    one->add_option("--metadata", o.metadata,
                    "Gradescope's submission_metadata.json, which names the student");
    add_common(*one, o);
    for (const auto& form : forms) {
        one->add_option("--" + form.first, o.files[form.first],
                        "file to write this form of the report to; - is standard output");
    }
}

void declare_class(CLI::App& app, Options& o) {
    CLI::App* all = app.add_subcommand("class", "Grades a folder of students");
    add_class(*all, o);
    all->add_option("--jobs", o.c.jobs, "students at a time")->check(CLI::Range(1, 256));
    all->add_option("--part", o.part, "I/N: only every Nth student, from the Ith");
    all->add_flag("--slurm", o.slurm, "by Slurm, in an array job")->excludes("--part");
    all->add_option("--chunk", o.chunk, "students for each task of the array")
        ->check(CLI::Range(1, 1000))
        ->capture_default_str();
    add_common(*all, o);
}

void declare_for_others(CLI::App& app, Options& o) {
    CLI::App* others = app.add_subcommand("export", "Writes a class as other programs take it");
    others->require_subcommand(1);
    CLI::App* jplag = others->add_subcommand("jplag", "For JPlag, which finds what is alike");
    add_class(*jplag, o);
    jplag->add_option("--handout", o.handout, "the students' tree, which is no one's own work")
        ->required()
        ->check(CLI::ExistingDirectory);
    jplag->add_option("--lesson", o.lessons, "numbers or names; all if left out");
    CLI::App* autograder = app.add_subcommand("bundle", "Writes what other systems grade with");
    autograder->require_subcommand(1);
    CLI::App* gradescope = autograder->add_subcommand("gradescope", "An autograder's archive");
    gradescope->add_option("archive", o.archive, "the zip archive to write")->required();
    gradescope->add_option("--lesson", o.lessons, "numbers or names")->required();
    gradescope->add_option("--secret", o.bundled_secret, "a file; hidden cases follow from it")
        ->required()
        ->check(CLI::ExistingFile);
    gradescope->add_option("--assignment", o.c.order.assignment, "hidden cases differ by its name")
        ->required();
}

void declare(CLI::App& app, Options& o) {
    app.require_subcommand(1);
    declare_one(app, o);
    declare_class(app, o);
    declare_for_others(app, o);
    app.add_subcommand("doctor", "Says which protections this machine has");
}

}  // namespace

Options parse_options(int argc, char** argv) {
    Options o;
    o.c.order.assignment = "course";
    CLI::App app("Grades what students hand in", "grade");
    declare(app, o);
    try {
        app.parse(argc, argv);
    } catch (const CLI::CallForHelp&) {
        std::cout << app.help();
        std::exit(0);
    } catch (const CLI::ParseError& e) {
        throw Error(std::string(e.what()) + " (see grade --help)");
    }
    o.command = app.get_subcommands().front()->get_name();
    finish(o);
    return o;
}

}  // namespace glint::grading
