// grade: what submissions are worth.
#include "framework/image/file.hpp"
#include "framework/math/error.hpp"
#include "tests/grading/doctor.hpp"
#include "tests/grading/grade_options.hpp"
#include "tests/grading/jplag.hpp"
#include "tests/grading/plain_text.hpp"
#include "tests/grading/scratch.hpp"
#include "tests/grading/slurm.hpp"

#include <iostream>
#include <sys/prctl.h>
#include <sys/stat.h>
#include <unistd.h>

namespace {

using namespace glint::grading;
using glint::Error;
using glint::write_text;

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

int here(const Options& o) {
    warn_of_others(o.c.folder);
    std::set<std::string> left = grade_class(o.c);
    if (o.c.parts == 1) {
        left.merge(sum_up(o.c));
    }
    return say_who_is_left(left);
}

int by_slurm(const Options& o) {
    warn_of_others(o.c.folder);
    run_array({part_command(o), std::filesystem::absolute(o.c.out) / "slurm", o.chunk, o.c.jobs},
              students_of(o.c.folder, o.c.roster).size());
    return say_who_is_left(sum_up(o.c));
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

int run(const Options& o) {
    return o.command == "one"      ? in_scratch([&] { return one(o); })
           : o.command == "class"  ? o.slurm ? by_slurm(o) : in_scratch([&] { return here(o); })
            : o.command == "export" ? similar(o)
           : o.command == "bundle" ? bundle(o)
                                   : doctor();
}

}  // namespace

int main(int argc, char** argv) {
    prctl(PR_SET_DUMPABLE, 0);  // nobody of this user reads this process's memory
    umask(022);
    try {
        return run(parse_options(argc, argv));
    } catch (const std::exception& e) {
        std::cerr << "error: " << e.what() << '\n';
        return 2;
    }
}
