#include "tests/grading/jplag.hpp"

#include "framework/image/file.hpp"
#include "framework/math/error.hpp"
#include "tests/grading/grade_lesson.hpp"
#include "tests/temporary.hpp"

namespace glint::grading {

namespace fs = std::filesystem;

namespace {

void write_header(const fs::path& folder, const Lesson& lesson, const std::string& text) {
    fs::create_directories(folder);
    write_text(folder / lesson.header, text);
}

void write_given(const fs::path& to, const Lesson& lesson, const fs::path& students_tree) {
    const Intake given = find_header(students_tree, lesson);
    if (!given.text) {
        throw Error(students_tree.string() + ": has no " + lesson.header +
                    "; name the tree that the students were given");
    }
    write_header(to, lesson, *given.text);
}

void write_submitted(const fs::path& to, const Lesson& lesson, const Student& s) {
    const Intake taken = s.submission.empty() ? Intake{} : find_header(s.submission, lesson);
    if (taken.is_ours) {
        throw Error(s.submission.string() + ": " + lesson.header + ' ' + taken.objection);
    }
    if (taken.text) {
        write_header(to / s.name, lesson, *taken.text);
    }
}

}  // namespace

void export_for_jplag(const ClassOrder& c, const fs::path& students_tree) {
    if (fs::exists(c.out)) {
        throw Error(c.out.string() + ": is there already; name a folder that is not");
    }
    const std::vector<Student> students = students_of(c.folder, c.roster);
    const fs::path parent = fs::absolute(c.out / "").parent_path().parent_path();
    if (!fs::is_directory(parent)) {
        throw Error(c.out.string() + ": there is no folder " + parent.string() + "; make it first");
    }
    const TemporaryFolder beside(parent);  // it takes its name when it is complete
    const fs::path out = beside / "out";
    for (const std::string& name : c.order.lessons.empty() ? graded_lessons() : c.order.lessons) {
        const Lesson lesson = cases_of(name, std::nullopt);
        write_given(out / "base", lesson, students_tree);
        for (const Student& s : students) {
            write_submitted(out / "submissions", lesson, s);
        }
    }
    fs::rename(out, c.out);
}

}  // namespace glint::grading
