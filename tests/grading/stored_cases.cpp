#include "framework/image/file.hpp"
#include "framework/math/error.hpp"
#include "tests/grading/cases.hpp"

#include <nlohmann/json.hpp>

namespace glint::grading {

Lesson cases_of(const std::string& lesson, const std::optional<Identity>& identity) {
    if (identity) {
        throw Error("hidden cases are not in this tree, the course has them");
    }
    return nlohmann::json::parse(read_text(lesson_file(lesson))).get<Lesson>();
}

}  // namespace glint::grading
