#include "framework/app/values.hpp"

#include "framework/math/dispatch.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <thread>

namespace glint {
namespace {

template <class Number>
std::optional<Number> number(const std::string& text) {
    Number value{};
    const char* end = text.data() + text.size();
    const auto [stop, error] = std::from_chars(text.data(), end, value);
    if (error != std::errc() || stop != end) {
        return std::nullopt;
    }
    return value;
}

std::optional<glm::vec3> three_numbers(const std::string& text) {
    const auto parts = split(text, ',');
    glm::vec3 v{};
    for (int i = 0; i < 3; ++i) {
        const auto value =
            parts.size() == 3 ? finite_number(parts[static_cast<std::size_t>(i)]) : std::nullopt;
        if (!value) {
            return std::nullopt;
        }
        v[i] = *value;
    }
    return v;
}

void require_light(const std::string& option, const std::string& text, const Rgb<float>& amount) {
    if (std::min({amount.r, amount.g, amount.b}) < 0) {
        refuse(option, text, "light is never negative");
    }
}

}  // namespace

void refuse(const std::string& option, const std::string& text, const std::string& allowed) {
    throw Error(option + " " + text + ": " + allowed);
}

std::vector<std::string> split(const std::string& text, char separator) {
    std::vector<std::string> parts{""};
    for (const char c : text) {
        if (c == separator) {
            parts.emplace_back();
        } else {
            parts.back() += c;
        }
    }
    return parts;
}

std::optional<int> whole_number(const std::string& text) {
    return number<int>(text);
}

std::optional<float> finite_number(const std::string& text) {
    const auto value = number<float>(text);
    return value && std::isfinite(*value) ? value : std::nullopt;
}

float number_within(const std::string& option, const std::string& text, float low, float high,
                    const std::string& allowed) {
    const auto value = finite_number(text);
    if (!value || *value < low || *value > high) {
        refuse(option, text, allowed);
    }
    return *value;
}

int count_up_to(const std::string& option, const std::string& text, int most) {
    const auto value = whole_number(text);
    if (!value || *value < 1 || *value > most) {
        refuse(option, text, "needs a whole number within 1.." + std::to_string(most));
    }
    return *value;
}

glm::vec3 triple(const std::string& option, const std::string& text) {
    const auto v = three_numbers(text);
    if (!v) {
        refuse(option, text, "needs three finite numbers with commas between, like 1,0.5,2");
    }
    return *v;
}

Rgb<float> reflectance(const std::string& option, const std::string& text) {
    const Rgb<float> c = triple(option, text);
    if (std::min({c.r, c.g, c.b}) < 0 || std::max({c.r, c.g, c.b}) > 1) {
        refuse(option, text, "reflectances lie within 0..1");
    }
    return c;
}

Rgb<float> light_amount(const std::string& option, const std::string& text) {
    const Rgb<float> c = triple(option, text);
    require_light(option, text, c);
    return c;
}

std::pair<glm::vec3, Rgb<float>> light_at(const std::string& option, const std::string& text) {
    const auto parts = split(text, ':');
    const auto at = parts.size() == 2 ? three_numbers(parts[0]) : std::nullopt;
    const auto amount = parts.size() == 2 ? three_numbers(parts[1]) : std::nullopt;
    if (!at || !amount) {
        refuse(option, text,
               "needs a place or direction and a colour, three finite numbers each, x,y,z:r,g,b");
    }
    require_light(option, text, *amount);
    return {*at, *amount};
}

std::pair<int, int> picture_size(const std::string& text) {
    const auto parts = split(text, 'x');
    const auto width = parts.size() == 2 ? whole_number(parts[0]) : std::nullopt;
    const auto height = parts.size() == 2 ? whole_number(parts[1]) : std::nullopt;
    if (!width || !height || *width < 1 || *height < 1 || *width > 16384 || *height > 16384) {
        refuse("--size", text, "needs WIDTHxHEIGHT within 1x1 and 16384x16384, like 1920x1080");
    }
    return {*width, *height};
}

int lane_count(const std::string& text) {
    if (text == "auto") {
        return max_lanes;
    }
    const auto value = whole_number(text);
    if (!value || !has_lanes(*value)) {
        refuse("--lanes", text,
               std::string("this build for ") + instruction_set + " has auto, 1, 4" +
                   (max_lanes >= 8 ? ", 8" : "") + (max_lanes >= 16 ? ", 16" : ""));
    }
    return *value;
}

int thread_count(const std::string& text) {
    if (text == "auto") {
        return std::clamp(static_cast<int>(std::thread::hardware_concurrency()), 1, 256);
    }
    return count_up_to("--threads", text, 256);
}

}  // namespace glint
