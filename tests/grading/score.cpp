#include "tests/grading/score.hpp"

#include "tests/grading/judge.hpp"
#include "tests/grading/picture.hpp"

#include <algorithm>
#include <map>

namespace glint::grading {
namespace {

struct Tried {
    const Case* asked;
    std::vector<Answered> answers;  // one a batch
};

struct TriedTask {
    const Task* task;
    std::vector<Tried> cases;
    const Mistake* mistake = nullptr;  // its own
};

double share_of(const Case& asked, const Batch& batch, const Answered& a) {
    return a.verdict == Verdict::ok ? earned_share(asked, batch, passed_share(batch, a.answers))
                                    : 0;
}

// Calls f(batch, answered) for each batch whose answers are not all right.
template <class F>
void for_each_wrong(const TriedTask& task, F f) {
    for (const Tried& t : task.cases) {
        for (std::size_t i = 0; i < t.answers.size(); ++i) {
            const Batch& batch = t.asked->batches[i];
            if (t.answers[i].verdict == Verdict::ok &&
                passed_share(batch, t.answers[i].answers) < 1) {
                f(batch, t.answers[i].answers);
            }
        }
    }
}

// The mistake that most of the wrong batches look like.
const Mistake* own_mistake(const TriedTask& task) {
    std::map<std::string, int> votes;
    const Mistake* most = nullptr;
    for_each_wrong(task, [&](const Batch& batch, const std::vector<double>& answers) {
        const Mistake* m = diagnose(batch, answers, task.task->id);
        if (m != nullptr && (++votes[m->words] > (most == nullptr ? 0 : votes[most->words]))) {
            most = m;
        }
    });
    return most;
}

// Does any question have another answer than the first?
bool differ(const Batch& batch, const std::vector<double>& answers) {
    const std::size_t width = batch.answers_a_row;
    return !std::equal(answers.begin() + static_cast<std::ptrdiff_t>(width), answers.end(),
                       answers.begin());
}

enum class Follows { no, untold, yes };

// Is all that is wrong here what another task's mistake makes of right answers? Untold where that
// gives every question the same answer: then others than the right ones would look like this, too.
Follows follows_from(const TriedTask& task, const Mistake& other) {
    bool all = true;
    bool any = false;
    bool told = false;
    for_each_wrong(task, [&](const Batch& batch, const std::vector<double>& answers) {
        const bool begun = diagnose_skeleton(batch, answers, task.task->id) == nullptr;
        all = all && begun && looks_like(batch, answers, other);
        any = true;
        told = told || differ(batch, answers);
    });
    return !any || !all ? Follows::no : told ? Follows::yes : Follows::untold;
}

Failure describe(const std::string& of, const Batch& batch, const Answered& a, std::size_t check) {
    const Check& c = batch.checks[check];
    const std::size_t first = c.terms.front().answer;
    const auto row = static_cast<std::ptrdiff_t>(first / batch.answers_a_row * batch.columns);
    const auto begin = batch.questions.begin() + row;
    double got = 0;
    for (const Check::Term& t : c.terms) {
        got += t.weight * a.answers[t.answer];
    }
    return {batch.number,
            of,
            {begin, begin + static_cast<std::ptrdiff_t>(batch.columns)},
            first % batch.answers_a_row,
            c.low,
            c.high,
            got,
            batch.frame.width > 0 ? place_of(batch, check) : ""};
}

CaseResult result_of(const std::string& of, const Tried& t, const std::string& follows) {
    CaseResult r{t.asked->name,
                 t.asked->kind,
                 t.asked->hidden,
                 t.asked->points,
                 0,
                 Verdict::ok,
                 follows,
                 std::nullopt,
                 0,
                 std::nullopt};
    double share = 1;
    for (std::size_t i = 0; i < t.answers.size(); ++i) {
        const Answered& a = t.answers[i];
        const Batch& batch = t.asked->batches[i];
        r.seconds = std::max(r.seconds, a.seconds);
        if (a.verdict != Verdict::ok) {
            r.verdict = a.verdict;
            r.words = a.words;
            return r;
        }
        const bool seen = batch.frame.width > 0;
        if (seen && !r.hidden) {
            r.shown = show(*t.asked, batch, a.answers);
        }
        const auto wrong = first_failure(batch, a.answers);
        if (wrong && follows.empty()) {
            share = std::min(share, share_of(*t.asked, batch, a));
            r.verdict = Verdict::wrong;
            r.failure =
                r.failure ? r.failure
                          : describe(of, batch, a, seen ? worst_failure(batch, a.answers) : *wrong);
        }
    }
    r.earned = share * r.points;
    return r;
}

void limit_properties(TaskResult& task) {
    for (const bool hidden : {false, true}) {
        double best = 0;
        for (const CaseResult& c : task.cases) {
            if (c.hidden == hidden && (c.kind == "values" || c.kind == "rows")) {
                best = std::max(best, c.earned / c.points);
            }
        }
        for (CaseResult& c : task.cases) {
            if (c.hidden == hidden && c.earned > best * c.points + 1e-9) {
                c.earned = best * c.points;
                c.verdict = c.verdict == Verdict::ok ? Verdict::wrong : c.verdict;
                c.words = "counts no more than the values of its task do";
            }
        }
    }
}

TaskResult result_of(const TriedTask& tried, const std::vector<TriedTask>& all) {
    std::string follows;
    TaskResult r{tried.task->id, tried.task->title, "", {}};
    for (const TriedTask& other : all) {
        if (&other == &tried || other.mistake == nullptr) {
            continue;
        }
        const Follows f = follows_from(tried, *other.mistake);
        if (f == Follows::yes) {
            follows = "follows from " + other.task->id;
        } else if (f == Follows::untold) {
            r.diagnosis = "any answer, right or wrong, until " + other.task->id + " is right";
        }
    }
    if (tried.mistake != nullptr) {
        r.diagnosis = tried.mistake->words;
    }
    if (!follows.empty()) {
        r.diagnosis.clear();
    }
    for (const Tried& t : tried.cases) {
        r.cases.push_back(result_of(tried.task->of, t, follows));
    }
    limit_properties(r);
    return r;
}

double sum(const auto& all, auto value) {
    double total = 0;
    for (const auto& one : all) {
        total += value(one);
    }
    return total;
}

Verdict worst_of(const LessonResult& r) {
    Verdict worst = Verdict::ok;
    for (const TaskResult& task : r.tasks) {
        for (const CaseResult& c : task.cases) {
            worst = c.verdict != Verdict::skipped ? std::max(worst, c.verdict) : worst;
        }
    }
    return worst;
}

}  // namespace

double TaskResult::points() const {
    return sum(cases, [](const CaseResult& c) { return c.points; });
}
double TaskResult::earned() const {
    return sum(cases, [](const CaseResult& c) { return c.earned; });
}
double LessonResult::points() const {
    return sum(tasks, [](const TaskResult& t) { return t.points(); });
}
double LessonResult::earned() const {
    return sum(tasks, [](const TaskResult& t) { return t.earned(); });
}

LessonResult score(const Lesson& lesson, const Answerer& answerer) {
    std::vector<TriedTask> all;
    for (const Task& task : lesson.tasks) {
        TriedTask tried{&task, {}};
        for (const Case& asked : task.cases) {
            tried.cases.push_back({&asked, {}});
            for (const Batch& batch : asked.batches) {
                tried.cases.back().answers.push_back(answerer(task.id.at(3) - '0', asked, batch));
            }
        }
        all.push_back(tried);
    }
    for (TriedTask& task : all) {
        task.mistake = own_mistake(task);
    }
    LessonResult r{lesson.name, Verdict::ok, "", {}};
    for (const TriedTask& task : all) {
        r.tasks.push_back(result_of(task, all));
    }
    r.verdict = worst_of(r);
    return r;
}

LessonResult not_run(const Lesson& lesson, Verdict verdict, const std::string& words) {
    LessonResult r = score(lesson, [&](int, const Case&, const Batch&) {
        return Answered{verdict, {}, "", 0};
    });
    r.verdict = verdict;
    r.words = words;
    return r;
}

}  // namespace glint::grading
