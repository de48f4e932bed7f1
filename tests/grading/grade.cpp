// grade: what submissions are worth.
#include "framework/image/file.hpp"
#include "framework/math/error.hpp"
#include "tests/grading/class.hpp"
#include "tests/grading/doctor.hpp"
#include "tests/grading/exports/exports.hpp"
#include "tests/grading/jplag.hpp"
#include "tests/grading/plain_text.hpp"
#include "tests/grading/slurm.hpp"

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include <iostream>
#include <map>
#include <set>
#include <sys/prctl.h>
#include <sys/stat.h>
#include <unistd.h>

namespace {

using namespace glint::grading;
using glint::Error;
using glint::read_text;
using glint::write_text;
using Form = std::string (*)(const Report&);

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

struct Options {
    ClassOrder c;  // what one submission is graded by, too
    std::vector<std::string> lessons;
    std::filesystem::path submission = SOURCE_FOLDER, secret, metadata, handout, archive,
                          bundled_secret;                // which is not read
    std::map<std::string, std::filesystem::path> files;  // by form
    std::string part;
    bool slurm = false;
    int chunk = 32;
};

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
    for (const nlohmann::json& user : nlohmann::json::parse(read_text(metadata)).at("users")) {
        ids.insert(user.at("id").dump());
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
    if (!o.part.empty() && (std::sscanf(o.part.c_str(), "%d/%d", &o.c.part, &o.c.parts) != 2 ||
                            o.c.part < 0 || o.c.part >= o.c.parts)) {
        throw Error("--part " + o.part + ": write 0/4 for the first of four");
    }
}

// In a student's tree one lesson's mistakes spoil those that include it.
void say_what_it_builds_on(std::ostream& out, const Report& report) {
    for (const LessonResult& l : report.lessons) {
        if (l.earned() < l.points() && l.verdict == Verdict::wrong) {
            for (const std::string& before : unsolved_before(l.lesson, SOURCE_FOLDER)) {
                out << before << " is not all right yet, and " << l.lesson
                    << " builds on it: begin there\n";
            }
        }
    }
}

int one(const Options& o) {
    require_submission(o.submission, o.c.order);
    const Report report = grade_submission(o.submission, o.c.order);
    if (report.lessons.empty()) {
        throw Error(o.submission.string() + ": no lesson's header is there");
    }
    bool printed = false;
    for (const auto& [form, file] : o.files) {
        if (file == "-") {
            std::cout << forms.at(form)(report);
            printed = true;
        } else if (!file.empty()) {
            write_text(file, forms.at(form)(report));
        }
    }
    std::ostream& out = printed ? std::cerr : std::cout;
    if (o.submission == SOURCE_FOLDER) {
        say_what_it_builds_on(out, report);
    }
    print(out, report);
    return report.is_final() ? 0 : 3;
}

// What grades a part of the class, which is to be named after it.
std::vector<std::string> part_command(const Options& o) {
    namespace fs = std::filesystem;
    std::vector<std::string> words{fs::read_symlink("/proc/self/exe"),
                                   "class",
                                   fs::absolute(o.c.folder),
                                   "--out",
                                   fs::absolute(o.c.out),
                                   "--jobs",
                                   std::to_string(o.c.jobs),
                                   "--assignment",
                                   o.c.order.assignment};
    for (const std::string& lesson : o.c.order.lessons) {
        words.insert(words.end(), {"--lesson", lesson});
    }
    if (!o.c.roster.empty()) {
        words.insert(words.end(), {"--roster", fs::absolute(o.c.roster)});
    }
    if (!o.secret.empty()) {
        words.insert(words.end(), {"--secret", fs::absolute(o.secret)});
    }
    words.emplace_back("--part");
    return words;
}

void warn_of_others(const std::filesystem::path& folder) {
    for (const std::filesystem::path& other : not_taken(folder)) {
        std::cerr << "warning: " << printable(other.string(), 200)
                  << ": is no folder and no zip archive, so it is nobody's submission\n";
    }
}

int say_who_is_left(const std::set<std::string>& students) {
    for (const std::string& student : students) {
        std::cerr << "to be graded again: " << printable(student, 80) << '\n';
    }
    return students.empty() ? 0 : 3;
}

int whole_class(const Options& o) {
    warn_of_others(o.c.folder);
    std::set<std::string> left;
    if (o.slurm) {
        run_array(
            {part_command(o), std::filesystem::absolute(o.c.out) / "slurm", o.chunk, o.c.jobs},
            students_of(o.c.folder, o.c.roster).size());
    } else {
        left = grade_class(o.c);
    }
    if (o.c.parts == 1) {
        left.merge(sum_up(o.c));
    }
    return say_who_is_left(left);
}

int similar(const Options& o) {
    warn_of_others(o.c.folder);
    export_for_jplag(o.c, o.handout);
    const std::string out = o.c.out.string();
    std::clog << "java -jar jplag.jar -l cpp -bc " << shell_word(out + "/base") << ' '
              << shell_word(out + "/submissions") << '\n';
    return 0;
}

// By the instructors' script.
int bundle(const Options& o) {
    const std::string script = SOURCE_FOLDER "/tests/grading/instructor/gradescope/bundle";
    std::vector<std::string> words{script, o.archive, o.bundled_secret, o.c.order.assignment};
    words.insert(words.end(), o.c.order.lessons.begin(), o.c.order.lessons.end());
    std::vector<char*> argv;
    argv.reserve(words.size() + 1);
    for (std::string& word : words) {
        argv.push_back(word.data());
    }
    argv.push_back(nullptr);
    execv(script.c_str(), argv.data());
    throw Error("this is the students' tree: only the instructor's makes autograders");
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

int run(int argc, char** argv) {
    Options o;
    o.c.order.assignment = "course";
    CLI::App app("Grades what students hand in", "grade");
    declare(app, o);
    CLI11_PARSE(app, argc, argv);
    finish(o);
    return app.got_subcommand("one")      ? one(o)
           : app.got_subcommand("class")  ? whole_class(o)
           : app.got_subcommand("export") ? similar(o)
           : app.got_subcommand("bundle") ? bundle(o)
                                          : doctor();
}

}  // namespace

int main(int argc, char** argv) {
    prctl(PR_SET_DUMPABLE, 0);  // nobody of this user reads this process's memory
    umask(022);
    try {
        return run(argc, argv);
    } catch (const std::exception& e) {
        std::cerr << "error: " << e.what() << '\n';
        return 2;
    }
}
