// The lessons' own headers, and each known mistake in them, as functions that answer questions.
// Compiled from the lessons' sources and from mutants/, one namespace a variant.
#pragma once

#include <span>
#include <string>

namespace glint::grading {

enum class VariantKind { solution, skeleton, mutant, alternative };

using Answer = void (*)(int task, const double* question, double* answer);

struct Variant {
    VariantKind kind;
    const char* task;   // where it differs from the solution; empty for everywhere
    const char* words;  // what mistake it is
    Answer as_float, as_double;
};

// The first is the solution, the second the whole skeleton. The lesson's name is its folder's; one
// that has no manifest is an Error.
std::span<const Variant> variants_of(const std::string& lesson);

}  // namespace glint::grading
