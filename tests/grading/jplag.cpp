#include "tests/grading/jplag.hpp"

#include "framework/image/file.hpp"
#include "framework/math/error.hpp"
#include "tests/grading/grade_lesson.hpp"

namespace glint::grading {

namespace fs = std::filesystem;

static void write_header(const fs::path& folder, const Lesson& lesson, const std::string& text) {
    fs::create_directories(folder);
    write_text(folder / lesson.header, text);
}

void export_for_jplag(const ClassOrder& c, const fs::path& students_tree) {
    if (fs::exists(c.out)) {
        throw Error(c.out.string() + ": is there already; name a folder that is not");
    }
    for (const std::string& name : c.order.lessons.empty() ? graded_lessons() : c.order.lessons) {
        const Lesson lesson = cases_of(name, std::nullopt);
        const Intake given = find_header(students_tree, lesson);
        if (!given.text) {
            throw Error(students_tree.string() + ": has no " + lesson.header +
                        "; name the tree that the students were given");
        }
        write_header(c.out / "base", lesson, *given.text);
        for (const Student& s : students_of(c.folder, c.roster)) {
            const Intake taken =
                s.submission.empty() ? Intake{} : find_header(s.submission, lesson);
            if (taken.is_ours) {
                throw Error(s.submission.string() + ": " + lesson.header + ' ' + taken.objection);
            }
            if (taken.text) {
                write_header(c.out / "submissions" / s.name, lesson, *taken.text);
            }
        }
    }
}

}  // namespace glint::grading
