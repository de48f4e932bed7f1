// make_class DIR COUNT: a class to measure the grader by, of which lesson 12 was handed in: right
// answers, skeletons, known mistakes and hostile submissions in turn.
#include "framework/image/file.hpp"
#include "tests/grading/instructor/marks.hpp"
#include "tests/grading/instructor/mutants.hpp"
#include "tests/grading/instructor/tests/submissions.hpp"

#include <iostream>

namespace {

using namespace glint::grading;
using glint::read_text;
using glint::write_text;
namespace fs = std::filesystem;

const fs::path root = SOURCE_FOLDER;

std::vector<std::string> headers() {
    const auto regions =
        read_marks("schlick.hpp", read_text(root / "lessons/12_schlick/schlick.hpp"));
    std::vector<std::string> all{with_answer(regions, "", {}), handed_out(regions)};
    const fs::path mutants = root / "tests/grading/instructor/mutants/12_schlick.txt";
    for (const Mutant& m : read_mutants(mutants.string(), read_text(mutants))) {
        all.push_back(with_answer(regions, m.task, m.code));
    }
    for (const char* file : {"honest.txt", "hostile.txt"}) {
        for (const Submission& s : read_submissions(file)) {
            all.push_back(s.text);
        }
    }
    return all;
}

}  // namespace

int main(int argc, char** argv) {
    try {
        if (argc != 3) {
            std::cerr << "usage: make_class DIR COUNT\n";
            return 2;
        }
        const std::vector<std::string> all = headers();
        for (std::size_t i = 0; i < std::stoul(argv[2]); ++i) {
            const fs::path folder = fs::path(argv[1]) / ("student_" + std::to_string(1000 + i));
            fs::create_directories(folder);
            write_text(folder / "schlick.hpp", all[i % all.size()]);
        }
    } catch (const std::exception& e) {
        std::cerr << "error: " << e.what() << '\n';
        return 2;
    }
}
