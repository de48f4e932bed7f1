#include "tests/grading/text_file.hpp"

#include "framework/math/error.hpp"

#include <fstream>
#include <sstream>

namespace glint::grading {

std::string read_text(const std::filesystem::path& path) {
    std::ifstream file(path, std::ios::binary);
    std::ostringstream text;
    text << file.rdbuf();
    if (!file) {
        throw Error(path.string() + ": cannot be read");
    }
    return text.str();
}

void write_text(const std::filesystem::path& path, const std::string& text) {
    std::filesystem::path beside = path;
    beside += ".new";
    std::ofstream file(beside, std::ios::binary);
    file << text;
    file.close();
    std::error_code failure;
    if (file) {
        std::filesystem::rename(beside, path, failure);
    }
    if (!file || failure) {
        throw Error(path.string() + ": cannot be written");
    }
}

}  // namespace glint::grading
