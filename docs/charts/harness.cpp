#include "docs/charts/harness.hpp"

#include "framework/measure/front.hpp"
#include "framework/image/srgb.hpp"

#include <cmath>
#include <limits>
#include <map>
#include <utility>

namespace glint::charts {
namespace {

std::vector<Row> time_all(const std::vector<Contender>& contenders, JudgedBy judged_by, int rounds,
                          const Clock& clock) {
    std::vector<std::function<void()>> work;
    work.reserve(contenders.size());
    for (const Contender& c : contenders) {
        work.push_back(c.work);
    }
    const std::vector<Times> times = time_in_turns(rounds, work, clock);
    std::vector<Row> rows;
    for (std::size_t i = 0; i < contenders.size(); ++i) {
        const double ns = 1e6 / contenders[i].amount;
        for (const Judgement& j : contenders[i].judgements) {
            rows.push_back({contenders[i].method, j, ns * times[i].median(),
                            ns * times[i].lower_quartile(), ns * times[i].upper_quartile(),
                            judged_by == JudgedBy::largest ? j.errors.largest : j.errors.rms,
                            false});
        }
    }
    return rows;
}

// Errors that agree to two digits are equal: the rest is the noise of rounding.
double two_digits(double error) {
    if (error == 0 || std::isinf(error)) {
        return error;
    }
    const double unit = std::pow(10.0, std::floor(std::log10(error)) - 1);
    return std::round(error / unit) * unit;
}

}  // namespace

void ErrorSum::add(double error) {
    const double size =
        std::isnan(error) ? std::numeric_limits<double>::infinity() : std::abs(error);
    largest_ = std::max(largest_, size);
    squares_ += size * size;
    ++count_;
}

Errors ErrorSum::errors() const {
    return {largest_, count_ == 0 ? 0 : std::sqrt(squares_ / static_cast<double>(count_))};
}

double code_of(double linear) {
    return 255 * srgb_encode(std::clamp(linear, 0.0, 1.0));
}

std::vector<Row> measure(const std::vector<Contender>& contenders, JudgedBy judged_by, int rounds,
                         const Clock& clock) {
    std::vector<Row> rows = time_all(contenders, judged_by, rounds, clock);
    std::map<std::pair<std::string, std::string>, std::vector<Row*>> tasks;
    for (Row& row : rows) {
        tasks[{row.judgement.variant, row.judgement.unit}].push_back(&row);
    }
    for (const auto& [task, rivals] : tasks) {
        std::vector<CostAndError> points;
        for (const Row* row : rivals) {
            points.push_back({row->ns, two_digits(row->error)});
        }
        const std::vector<bool> on_front = pareto_front(points);
        for (std::size_t i = 0; i < rivals.size(); ++i) {
            rivals[i]->on_front = on_front[i];
        }
    }
    return rows;
}

}  // namespace glint::charts
