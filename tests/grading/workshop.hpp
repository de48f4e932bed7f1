// A folder of its own for each submission, where its header is compiled and its answers are run.
#pragma once

#include "tests/grading/case.hpp"
#include "tests/grading/score.hpp"
#include "tests/temporary.hpp"

#include <filesystem>

namespace glint::grading {

struct Compiled {
    Verdict verdict;
    std::string words;  // the compiler's first errors
};

class Workshop {
  public:
    // Lays the text over the lessons before it: what the header may include is copied from root,
    // all of the framework and the earlier lessons.
    Workshop(const Lesson& lesson, const std::string& text, const std::filesystem::path& root);

    Compiled compile();

    // After compile() said ok. Questions are asked twice, in two orders, some of them repeated:
    // what answers otherwise the second time is wrong.
    Answered ask(int task, const Batch& batch);

  private:
    Compiled assemble();
    Answered ask_once(int task, const Batch& batch, int order);

    Lesson lesson_;
    TemporaryFolder home_;
    std::filesystem::path folder_;
};

}  // namespace glint::grading
