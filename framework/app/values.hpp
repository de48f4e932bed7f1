// From the words of a command line to values; each Error names the option and what it allows.
#pragma once

#include "framework/math/error.hpp"
#include "framework/math/vec.hpp"

#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace glint {

[[noreturn]] void refuse(const std::string& option, const std::string& text,
                         const std::string& allowed);

std::vector<std::string> split(const std::string& text, char separator);

std::optional<int> whole_number(const std::string& text);
std::optional<float> finite_number(const std::string& text);

float number_within(const std::string& option, const std::string& text, float low, float high,
                    const std::string& allowed);  // low <= number <= high
int count_up_to(const std::string& option, const std::string& text, int most);  // 1..most
glm::vec3 triple(const std::string& option, const std::string& text);           // "x,y,z"
Rgb<float> reflectance(const std::string& option, const std::string& text);     // each within 0..1
Rgb<float> light_amount(const std::string& option, const std::string& text);    // each >= 0
std::pair<glm::vec3, Rgb<float>> light_at(const std::string& option,
                                          const std::string& text);  // "x,y,z:r,g,b"
std::pair<int, int> picture_size(const std::string& text);           // "WxH"
int lane_count(const std::string& text);    // "auto" or one of this build's
int thread_count(const std::string& text);  // "auto" or 1..256

template <class Value>
Value choice(const std::string& option, const std::string& text,
             const std::map<std::string, Value>& choices) {
    const auto found = choices.find(text);
    if (found == choices.end()) {
        std::string allowed = "is not one of";
        for (const auto& [name, value] : choices) {
            allowed += " " + name;
        }
        refuse(option, text, allowed);
    }
    return found->second;
}

}  // namespace glint
