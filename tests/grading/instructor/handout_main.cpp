// handout DIR: writes the students' tree.
#include "framework/math/error.hpp"
#include "tests/grading/instructor/handout.hpp"

#include <iostream>
#include <string>

int main(int argc, char** argv) {
    if (argc != 2 || std::string(argv[1]).starts_with("-")) {
        const bool help = argc == 2 && std::string(argv[1]) == "--help";
        (help ? std::cout : std::cerr)
            << "usage: handout DIR\nWrites the students' tree to DIR: skeletons for answers, "
               "visible cases only.\n";
        return help ? 0 : 2;
    }
    try {
        glint::grading::hand_out(SOURCE_FOLDER, argv[1]);
        std::cerr << "handout: wrote " << argv[1] << '\n';
    } catch (const std::exception& e) {
        std::cerr << "error: " << e.what() << '\n';
        return 2;
    }
}
