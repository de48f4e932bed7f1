// Pages of HTML from a template: text with {{names}} to fill in, and with sections to cut out and
// repeat, each between two lines <!-- begin NAME --> and <!-- end NAME -->.
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <string_view>

namespace glint {

using Values = std::map<std::string, std::string>;

// Cuts a section out of text, leaving {{NAME}} in its place. Error where it is not there.
std::string take_section(std::string& text, const std::string& name);

// Puts values in the place of their names, once: {{ in a value stays. Error for a name without one.
std::string fill(std::string_view text, const Values& values);

// Text as it can stand between tags and in quoted attributes.
std::string escape(std::string_view text);

// A file as an address that holds it: data:TYPE;base64,... Error where it cannot be read.
std::string data_uri(const std::filesystem::path& path, const std::string& type);

}  // namespace glint
