// Runs a program as its users do: in a folder, by the shell.
#pragma once

#include "framework/image/file.hpp"
#include "tests/temporary.hpp"

#include <algorithm>
#include <cstdlib>
#include <stdexcept>
#include <string>
#include <sys/wait.h>

#ifndef EMULATOR
#define EMULATOR ""  // what runs the programs of another processor
#endif

namespace glint {

inline std::string text_of(const std::filesystem::path& path) {
    const auto bytes = read_file(path);
    return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

inline long lines(const std::string& text) {
    return std::count(text.begin(), text.end(), '\n');
}

struct Run {
    int status;
    std::string out, err;
};

inline Run run(const std::string& program, const TemporaryFolder& folder,
               const std::string& arguments) {
    const TemporaryFolder words;
    const std::string command = "cd '" + (folder / "").string() + "' && " EMULATOR " '" + program +
                                "' " + arguments + " > '" + (words / "out").string() + "' 2> '" +
                                (words / "err").string() + "'";
    const int result = std::system(command.c_str());
    if (!WIFEXITED(result)) {
        throw std::runtime_error("a signal ended " + command);
    }
    return {WEXITSTATUS(result), text_of(words / "out"), text_of(words / "err")};
}

}  // namespace glint
