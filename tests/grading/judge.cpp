#include "tests/grading/judge.hpp"

#include <algorithm>
#include <cmath>

namespace glint::grading {
namespace {

// How near an answer must come to a mistake's, of the largest answer and of itself.
constexpr double nearness = 2e-5;

bool both_not_finite(double a, double b) {
    return !std::isfinite(a) && !std::isfinite(b);
}

bool agrees(const Mistake& mistake, std::span<const double> answers) {
    double scale = 0;
    for (const double a : mistake.answers) {
        scale = std::isfinite(a) ? std::max(scale, std::abs(a)) : scale;
    }
    std::size_t near = 0;
    for (std::size_t i = 0; i < answers.size(); ++i) {
        const double other = mistake.answers[i];
        const double off = std::abs(answers[i] - other);
        near += both_not_finite(answers[i], other) ||
                off <= nearness * std::abs(other) + 1e-2 * nearness * scale;
    }
    return static_cast<double>(near) >= 0.99 * static_cast<double>(answers.size());
}

double distance(const Mistake& mistake, std::span<const double> answers) {
    double sum = 0;
    for (std::size_t i = 0; i < answers.size(); ++i) {
        const double off = std::abs(answers[i] - mistake.answers[i]);
        sum += std::isfinite(off) ? off : 0;
    }
    return sum;
}

// Of the known mistakes that fit, the one whose answers are nearest; of the same answers, a task's
// own rather than those of a header in which nothing is done.
template <class Fits>
const Mistake* nearest(const Batch& batch, std::span<const double> answers, Fits fits) {
    const Mistake* best = nullptr;
    for (const Mistake& m : batch.mistakes) {
        if (!fits(m) || !agrees(m, answers)) {
            continue;
        }
        const double nearer =
            best == nullptr ? -1 : distance(m, answers) - distance(*best, answers);
        if (nearer < 0 || (nearer == 0 && best->task.empty())) {
            best = &m;
        }
    }
    return best;
}

}  // namespace

bool passes(const Check& check, std::span<const double> answers) {
    double sum = 0;
    for (const Check::Term& t : check.terms) {
        sum += t.weight * answers[t.answer];
    }
    return sum >= check.low && sum <= check.high;
}

double passed_share(const Batch& batch, std::span<const double> answers) {
    const auto count = std::count_if(batch.checks.begin(), batch.checks.end(),
                                     [&](const Check& c) { return passes(c, answers); });
    return static_cast<double>(count) / static_cast<double>(batch.checks.size());
}

double earned_share(const Case& asked, const Batch& batch, double passed) {
    const double floor = asked.is_property() ? 0 : batch.floor;
    const double above = (passed - floor) / (1 - floor);
    return above >= 0.995 ? 1 : above >= 0.9 ? 0.7 : above >= 0.5 ? 0.3 : 0;
}

std::optional<std::size_t> first_failure(const Batch& batch, std::span<const double> answers) {
    for (std::size_t i = 0; i < batch.checks.size(); ++i) {
        if (!passes(batch.checks[i], answers)) {
            return i;
        }
    }
    return std::nullopt;
}

const Mistake* diagnose(const Batch& batch, std::span<const double> answers,
                        const std::string& task) {
    return nearest(batch, answers, [&](const Mistake& m) {
        return m.task == task || (m.task.empty() && m.skeleton);
    });
}

const Mistake* diagnose_skeleton(const Batch& batch, std::span<const double> answers,
                                 const std::string& task) {
    return nearest(batch, answers, [&](const Mistake& m) {
        return m.skeleton && (m.task == task || m.task.empty());
    });
}

bool looks_like(const Batch& batch, std::span<const double> answers, const Mistake& mistake) {
    return nearest(batch, answers, [&](const Mistake& m) {
               return m.task == mistake.task && m.words == mistake.words;
           }) != nullptr;
}

}  // namespace glint::grading
