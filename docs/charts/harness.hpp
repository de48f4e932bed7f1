// Measures what methods cost and how far they are off, and finds those that nothing beats.
#pragma once

#include "framework/measure/timing.hpp"

#include <cstdint>
#include <string>
#include <vector>

namespace glint::charts {

struct Errors {
    double largest = 0, rms = 0;
};

// Of signed errors; one that is NaN counts as infinite.
class ErrorSum {
  public:
    void add(double error);
    Errors errors() const;

  private:
    double largest_ = 0, squares_ = 0;
    std::int64_t count_ = 0;
};

// 255 times the sRGB curve, not rounded. Below 0 and above 1 it stays on the ends of the scale.
double code_of(double linear);

// How far a method is off on one task.
struct Judgement {
    std::string variant, unit;
    Errors errors;
};

struct Contender {
    std::string method;
    std::function<void()> work;  // does the task amount times
    double amount;
    std::vector<Judgement> judgements;  // one cost, by as many measures as one likes
};

// Which of the errors decides.
enum class JudgedBy { largest, rms };

struct Family {
    std::string name;
    std::string per;  // what amount counts: "evaluation", "fragment", "pixel"
    JudgedBy judged_by;
    int rounds;
    std::vector<Contender> (*contenders)();
};

struct Row {
    std::string method;
    Judgement judgement;
    double ns, ns_low, ns_high;  // median and quartiles of one task
    double error;                // the one that decides
    bool on_front;               // of the same variant and unit, by two digits of error
};

std::vector<Row> measure(const std::vector<Contender>& contenders, JudgedBy judged_by, int rounds,
                         const Clock& clock = steady_ms);

}  // namespace glint::charts
