#include "tests/grading/instructor/tests/submissions.hpp"

#include "framework/image/file.hpp"
#include "tests/grading/cases.hpp"
#include "tests/grading/instructor/marks.hpp"

#include <regex>
#include <sstream>

namespace glint::grading {
namespace {

const std::filesystem::path root = SOURCE_FOLDER;

struct Parts {
    std::string verdict, words, before;
    Lines answer;
    bool has_answer;
};

std::vector<Parts> read_parts(const std::string& text) {
    static const std::regex head(
        "// SUBMISSION (ok|(?:compile|link) error|(?:compile|output) limit|[a-z]+) (.+)");
    std::vector<Parts> all;
    std::istringstream lines(text);
    for (std::string line; std::getline(lines, line);) {
        std::smatch match;
        if (std::regex_match(line, match, head)) {
            all.push_back({match[1], match[2], "", {}, false});
        } else if (line == "// ANSWER") {
            all.back().has_answer = true;
        } else if (all.back().has_answer) {
            all.back().answer.push_back(line);
        } else {
            all.back().before += line + '\n';
        }
    }
    return all;
}

}  // namespace

std::vector<Submission> read_submissions(const std::string& file) {
    const auto regions =
        read_marks("schlick.hpp", read_text(root / "lessons/12_schlick/schlick.hpp"));
    std::vector<Submission> all;
    for (const Parts& p :
         read_parts(read_text(root / "tests/grading/instructor/submissions" / file))) {
        const std::string text =
            p.before + with_answer(regions, p.has_answer ? "12.1" : "", p.answer);
        all.push_back({p.verdict, p.words,
                       std::regex_replace(text, std::regex("SOURCE_FOLDER"), root.string())});
    }
    return all;
}

Lesson lesson_of_submissions() {
    Lesson lesson = cases_of("12_schlick", Identity{"an unknown secret", "course", "somebody"});
    lesson.tasks.resize(1);
    return lesson;
}

LessonResult graded(const Submission& submission) {
    static const Lesson lesson = lesson_of_submissions();
    return grade_lesson(lesson, {submission.text, ""}, root);
}

}  // namespace glint::grading
