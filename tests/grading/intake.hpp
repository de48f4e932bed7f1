// Takes in what was handed in: text of a moderate size from a regular file, nothing else.
#pragma once

#include <filesystem>
#include <optional>
#include <string>

namespace glint::grading {

struct Intake {
    std::optional<std::string> text;
    std::string objection;  // why there is none; empty where there is no such file
    bool is_ours = false;   // the objection is to the grader, which cannot read what is there
};

inline Intake refuse(const std::string& why) {
    return {std::nullopt, why};
}

inline Intake cannot_read(const std::string& why) {
    return {std::nullopt, "cannot be read: " + why, true};
}

inline constexpr std::size_t largest_submission = std::size_t{256} * 1024;

// The file at a path below the folder, or the folder itself where that is empty. No part of the
// path may be a link.
Intake take_in(const std::filesystem::path& folder, const std::filesystem::path& below);

}  // namespace glint::grading
