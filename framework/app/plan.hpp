// --tolerance: the cheapest way to draw a picture whose colours stay within a tolerance.
//
// What can be cheaper: forms of the lesson's parameters (Parameter::forms), and shading once a
// pixel and triangle where every sample was asked for. Every choice is drawn and compared, at every
// pixel, with the full model; what the full model itself is off is measured against double on a
// picture of a sixteenth of the pixels, and counted twice. Errors are in sRGB codes, 0..255, before
// they are rounded to 8 bits.
#pragma once

#include "framework/app/lesson.hpp"

#include <string>
#include <vector>

namespace glint {

// A way to draw, and what it takes.
struct Way {
    Parameters parameters{};
    bool sample_shading = false;
    double ms = 0;     // least time of a frame
    double error = 0;  // a bound on the largest error, codes
};

// What the plan does cheaper than the full model, and the plan without it.
struct Saving {
    std::string full, cheaper;  // "exact Fresnel", "Schlick"
    Way without;
};

struct Plan {
    double tolerance = 0;
    Way full{}, chosen{};
    std::vector<Saving> savings{};
    bool met() const { return chosen.error <= tolerance; }
};

// The plan for options.tolerance. Where nothing meets it, the full model is chosen. Parameters that
// the command line sets stay as they are.
Plan make_plan(const Lesson& lesson, const Options& options, const Scene& scene);

// The options that draw it.
Options planned(const Plan& plan, Options options);

// The plan in words: a line for what was chosen, one for each saving, of what going back would cost
// and bring.
std::string plan_table(const Plan& plan);

}  // namespace glint
