// The questions of one case and the checks of their answers.
#pragma once

#include "tests/grading/case.hpp"
#include "tests/grading/instructor/random.hpp"
#include "tests/grading/instructor/variants.hpp"

#include <nlohmann/json_fwd.hpp>

namespace glint::grading {

struct Wanted {
    const nlohmann::json& task;  // as in the manifest
    const nlohmann::json& asked;
    std::span<const Variant> variants;
    std::uint64_t seed;
};

// An Error where trivial answers pass all checks of values.
Batch make_batch(const Wanted& wanted, const std::string& number);

}  // namespace glint::grading
