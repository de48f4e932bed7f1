#include "framework/app/programs/page.hpp"

#include "framework/image/file.hpp"
#include "framework/math/error.hpp"

#include <cstdint>

namespace glint {
namespace {

// RFC 4648, section 4.
std::string base64(std::span<const std::byte> bytes) {
    constexpr std::string_view digits =
        "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string text;
    text.reserve((bytes.size() + 2) / 3 * 4);
    for (std::size_t i = 0; i < bytes.size(); i += 3) {
        const std::size_t count = std::min<std::size_t>(3, bytes.size() - i);
        std::uint32_t group = 0;
        for (std::size_t k = 0; k < 3; ++k) {
            group = group << 8 | (k < count ? std::to_integer<std::uint32_t>(bytes[i + k]) : 0);
        }
        for (std::size_t k = 0; k < 4; ++k) {
            text += k <= count ? digits[group >> (18 - 6 * k) & 63] : '=';
        }
    }
    return text;
}

}  // namespace

std::string take_section(std::string& text, const std::string& name) {
    const std::string begin = "<!-- begin " + name + " -->\n";
    const std::string end = "<!-- end " + name + " -->\n";
    const auto first = text.find(begin);
    const auto last = text.find(end);
    if (first == std::string::npos || last == std::string::npos || last < first) {
        throw Error("the template has no section " + name);
    }
    const auto inside = first + begin.size();
    std::string section = text.substr(inside, last - inside);
    text.replace(first, last + end.size() - first, "{{" + name + "}}");
    return section;
}

std::string fill(std::string_view text, const Values& values) {
    std::string filled;
    for (auto open = text.find("{{"); open != std::string_view::npos; open = text.find("{{")) {
        const auto close = text.find("}}", open);
        const std::string name(text.substr(open + 2, close - open - 2));
        const auto value = values.find(name);
        if (close == std::string_view::npos || value == values.end()) {
            throw Error("the template asks for {{" + name + "}}, which there is not");
        }
        filled.append(text.substr(0, open)).append(value->second);
        text.remove_prefix(close + 2);
    }
    return filled.append(text);
}

std::string escape(std::string_view text) {
    std::string escaped;
    for (const char c : text) {
        switch (c) {
            case '&':
                escaped += "&amp;";
                break;
            case '<':
                escaped += "&lt;";
                break;
            case '>':
                escaped += "&gt;";
                break;
            case '"':
                escaped += "&quot;";
                break;
            default:
                escaped += c;
        }
    }
    return escaped;
}

std::string data_uri(const std::filesystem::path& path, const std::string& type) {
    return "data:" + type + ";base64," + base64(read_file(path));
}

}  // namespace glint
