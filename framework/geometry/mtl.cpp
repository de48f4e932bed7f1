// tinyobjloader also reads MTL, but it takes what a file leaves out, or spells wrongly, for 0.
#include "framework/geometry/mtl.hpp"

#include "framework/geometry/obj_spelling.hpp"
#include "framework/geometry/obj_text.hpp"
#include "framework/math/error.hpp"

#include <algorithm>
#include <charconv>
#include <fstream>

namespace glint {
namespace {

std::optional<float> to_number(std::string_view word) {
    float value = 0.0F;
    if (!is_number(word)) {
        return std::nullopt;
    }
    word.remove_prefix(word.front() == '+' ? 1 : 0);
    const auto result = std::from_chars(word.data(), word.data() + word.size(), value);
    return result.ec == std::errc{} ? std::optional(value) : std::nullopt;
}

// r g b, or one number for all three.
std::optional<Rgb<float>> to_colour(std::string_view arguments) {
    const auto r = to_number(take_word(arguments));
    const std::string_view second = take_word(arguments);
    if (r && second.empty()) {
        return Rgb<float>(*r);
    }
    const auto g = to_number(second);
    const auto b = to_number(take_word(arguments));
    return r && g && b ? std::optional(Rgb<float>(*r, *g, *b)) : std::nullopt;
}

// Cuts off the options in front of a file name and says whether there were any.
bool take_options(std::string_view& arguments) {
    bool any = false;
    while (arguments.starts_with('-')) {
        any = true;
        const std::string_view option = take_word(arguments);
        if (option == "-o" || option == "-s" || option == "-t" || option == "-mm") {
            for (std::string_view rest = arguments; is_number(take_word(rest));) {
                arguments = rest;
            }
        } else {
            take_word(arguments);
        }
        arguments.remove_prefix(std::min(arguments.find_first_not_of(" \t"), arguments.size()));
    }
    return any;
}

class MtlReader {
  public:
    MtlReader(const std::filesystem::path& path, Warnings& warnings)
        : path_(path), warnings_(warnings) {}

    void read(const Statement& s) {
        line_ = s.line;
        if (s.keyword == "newmtl") {
            begin(s.arguments);
        } else if (s.keyword == "Kd") {
            set_colour(&Material::diffuse, s);
        } else if (s.keyword == "Ks") {
            set_colour(&Material::specular, s);
        } else if (s.keyword == "Ns") {
            set_number(&Material::exponent, s, 0.0F);
        } else if (s.keyword == "Ni") {
            set_number(&Material::ior, s, std::numeric_limits<float>::min());
        } else if (s.keyword == "map_Kd") {
            set_map(s.arguments);
        }
    }
    std::vector<Material> take() { return std::move(materials_); }

  private:
    void warn(const std::string& text) { warnings_.add(at_line(path_, line_) + text); }

    void begin(std::string_view name) {
        if (materials_.size() == max_materials) {
            throw Error(at_line(path_, line_) + "more than 65536 materials");
        }
        materials_.emplace_back().name = name;
    }
    Material& current() {
        if (materials_.empty()) {
            warn("stands before the first newmtl: ignored");
            return ignored_;
        }
        return materials_.back();
    }
    void set_colour(Rgb<float> Material::*member, const Statement& s) {
        const auto colour = to_colour(s.arguments);
        if (!colour) {
            warn(std::string(s.keyword) + " needs three numbers: ignored");
            return;
        }
        const Rgb<float> limited = glm::clamp(*colour, 0.0F, 1.0F);
        if (limited != *colour) {
            warn(std::string(s.keyword) + " is limited to 0..1");
        }
        current().*member = limited;
    }
    void set_number(float Material::*member, const Statement& s, float low) {
        std::string_view arguments = s.arguments;
        const auto number = to_number(take_word(arguments));
        if (number && *number >= low) {
            current().*member = *number;
        } else {
            warn(std::string(s.keyword) + " needs a number " + (low > 0.0F ? "> 0" : ">= 0") +
                 ": ignored");
        }
    }
    void set_map(std::string_view arguments) {
        if (take_options(arguments)) {
            warn("the options of map_Kd are ignored");
        }
        std::string name(arguments);
        std::replace(name.begin(), name.end(), '\\', '/');
        const std::filesystem::path file = path_.parent_path() / name;
        if (name.empty() || !is_file(file) || !std::ifstream(file)) {
            warn("picture " + shown(name) + " cannot be read: left out");
            return;
        }
        current().diffuse_map = file.string();
    }

    const std::filesystem::path& path_;
    Warnings& warnings_;
    std::size_t line_ = 0;
    std::vector<Material> materials_;
    Material ignored_;
};

}  // namespace

std::vector<Material> parse_mtl(std::string_view text, const std::filesystem::path& path,
                                Warnings& warnings) {
    MtlReader reader(path, warnings);
    Statements statements(text);
    while (const auto statement = statements.next()) {
        reader.read(*statement);
    }
    return reader.take();
}

}  // namespace glint
