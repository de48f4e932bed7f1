// What answers are worth, and which known mistake they look like. Knows nothing of processes.
#pragma once

#include "tests/grading/case.hpp"

#include <optional>
#include <span>

namespace glint::grading {

// A sum that is not a number lies between no bounds.
bool passes(const Check& check, std::span<const double> answers);

// The share of checks that are passed, 0..1.
double passed_share(const Batch& batch, std::span<const double> answers);

// What a share earns of the case's points, 0, 0.3, 0.7 or 1: in steps, from above what trivial
// answers pass; of a property, which black may pass entirely, from 0.
double earned_share(const Case& asked, const Batch& batch, double passed);

// The first check that fails.
std::optional<std::size_t> first_failure(const Batch& batch, std::span<const double> answers);

// The mistake in the task whose answers these are; null where it is none that is known.
const Mistake* diagnose(const Batch& batch, std::span<const double> answers,
                        const std::string& task);

// The same among answers of skeletons: of the task's, and of the header's where nothing was done.
const Mistake* diagnose_skeleton(const Batch& batch, std::span<const double> answers,
                                 const std::string& task);

// Are these the answers that a mistake, seen in another batch, makes here?
bool looks_like(const Batch& batch, std::span<const double> answers, const Mistake& mistake);

}  // namespace glint::grading
