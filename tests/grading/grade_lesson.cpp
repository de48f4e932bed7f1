#include "tests/grading/grade_lesson.hpp"

#include "tests/grading/archive.hpp"
#include "tests/grading/workshop.hpp"

namespace glint::grading {
namespace {

// Who runs out of time again and again is not asked for ever.
constexpr int most_timeouts = 3;

LessonResult grade_text(const Lesson& lesson, const std::string& text,
                        const std::filesystem::path& root) {
    Workshop workshop(lesson, text, root);
    const Compiled compiled = workshop.compile();
    if (compiled.verdict != Verdict::ok) {
        return not_run(lesson, compiled.verdict, compiled.words);
    }
    int timeouts = 0;
    return score(lesson, [&](int task, const Case&, const Batch& batch) {
        if (timeouts == most_timeouts) {
            return Answered{Verdict::timeout, {}, "not asked any more", 0};
        }
        Answered a = workshop.ask(task, batch);
        timeouts += a.verdict == Verdict::timeout ? 1 : 0;
        return a;
    });
}

}  // namespace

LessonResult grade_lesson(const Lesson& lesson, const Intake& submitted,
                          const std::filesystem::path& root) {
    try {
        return submitted.text ? grade_text(lesson, *submitted.text, root)
               : submitted.objection.empty()
                   ? not_run(lesson, Verdict::skipped, "not handed in")
                   : not_run(lesson,
                             submitted.is_ours ? Verdict::internal_error : Verdict::rejected,
                             lesson.header + ": " + submitted.objection);
    } catch (const std::exception& e) {
        return not_run(lesson, Verdict::internal_error, e.what());
    }
}

Intake find_header(const std::filesystem::path& submission, const Lesson& lesson) {
    namespace fs = std::filesystem;
    if (submission.filename() == lesson.header) {
        Intake taken = take_in(submission, "");
        if (taken.text || !fs::is_directory(fs::symlink_status(submission))) {
            return taken;
        }
    }
    if (is_archive(submission)) {
        return take_from_archive(submission, lesson.header);
    }
    const Intake flat = take_in(submission, lesson.header);
    return flat.text || !flat.objection.empty()
               ? flat
               : take_in(submission, fs::path("lessons") / lesson.name / lesson.header);
}

}  // namespace glint::grading
