#include "tests/unit/rooms.hpp"

#include <algorithm>
#include <map>
#include <regex>
#include <set>
#include <sstream>

namespace glint::rooms {
namespace {

std::vector<std::string> parts_of(const std::string& path) {
    std::vector<std::string> parts;
    std::istringstream rest(path);
    for (std::string part; std::getline(rest, part, '/');) {
        parts.push_back(part);
    }
    return parts;
}

bool contains(const std::vector<std::string>& all, const std::string& one) {
    return std::find(all.begin(), all.end(), one) != all.end();
}

// Two digits and an underscore; -1 for folders that are no lesson.
int lesson_number(const std::string& folder) {
    static const std::regex numbered("[0-9][0-9]_.*");
    return std::regex_match(folder, numbered) ? std::stoi(folder.substr(0, 2)) : -1;
}

// Why a file may not include a header of the project; empty where it may.
std::string objection(const std::vector<std::string>& from, const std::vector<std::string>& to) {
    if (to.size() < 2 || (to[0] != "framework" && to[0] != "lessons" && to[0] != "tests")) {
        return "headers are named by their full path from the root";
    }
    if (to[0] == "tests") {
        return "nothing includes tests";
    }
    if (from[0] == "framework") {
        const bool same = to[0] == "framework" && to[1] == from[1];
        const bool below = to[0] == "framework" && contains(allowed_rooms(from[1]), to[1]);
        return same || below ? "" : "framework/" + from[1] + " stands below it or beside it";
    }
    const int own = lesson_number(from[1]);
    if (to[0] == "lessons" && to[1] != from[1] && own >= 0 && lesson_number(to[1]) >= own) {
        return "a lesson includes earlier lessons only";
    }
    if (to[0] == "lessons" && to[1] != from[1] && lesson_number(to[1]) < 0) {
        return "what is no lesson belongs to nobody else";
    }
    return "";
}

std::string package_objection(const std::string& path, const std::string& header) {
    for (const PackagePlaces& package : package_places()) {
        if (header.starts_with(package.header) && !contains(package.files, path)) {
            return "this package has its own file";
        }
    }
    return "";
}

}  // namespace

std::vector<Include> includes_of(const std::string& text) {
    static const std::regex include(R"(^\s*#\s*include\s*([<"])([^>"]+)[>"].*)");
    std::vector<Include> all;
    std::istringstream lines(text);
    int number = 0;
    for (std::string line; std::getline(lines, line);) {
        ++number;
        std::smatch match;
        if (std::regex_match(line, match, include)) {
            all.push_back({number, match[2], match[1] == "\""});
        }
    }
    return all;
}

std::vector<std::string> broken_rules(std::span<const Source> sources) {
    std::vector<std::string> broken;
    for (const Source& source : sources) {
        const auto from = parts_of(source.path);
        if (from[0] == "tests") {
            continue;
        }
        for (const Include& i : includes_of(source.text)) {
            const std::string why = i.quoted ? objection(from, parts_of(i.header))
                                             : package_objection(source.path, i.header);
            if (!why.empty()) {
                broken.push_back(source.path + ":" + std::to_string(i.line) + ": includes " +
                                 i.header + ", but " + why);
            }
        }
    }
    return broken;
}

std::vector<std::string> allowed_rooms(const std::string& room) {
    static const std::map<std::string, std::vector<std::string>> below{
        {"math", {}},
        {"image", {"math"}},
        {"geometry", {"math"}},
        {"raster", {"math", "image", "geometry"}},
        {"scene", {"math", "image", "geometry"}},
        {"measure", {"math"}},
        {"app", {"math", "image", "geometry", "raster", "scene", "measure"}},
    };
    const auto found = below.find(room);
    return found == below.end() ? std::vector<std::string>() : found->second;
}

std::span<const PackagePlaces> package_places() {
    static const std::vector<PackagePlaces> all{
        {"xsimd/", {"framework/math/registers.hpp"}},
        {"stb/stb_image", {"framework/image/png.cpp"}},
        {"stb/", {"framework/image/png.cpp", "framework/app/text.cpp"}},
        {"tiny_obj_loader", {"framework/geometry/obj.cpp"}},
        {"SDL", {"framework/app/window.cpp"}},
        {"CLI/",
         {"framework/app/options.cpp", "framework/app/programs/compare.cpp",
          "framework/app/programs/coverage.cpp"}},
        {"nlohmann/",
         {"framework/app/statistics.cpp", "framework/app/programs/compare.cpp",
          "framework/app/programs/gallery.cpp"}},
        {"doctest/", {}},
    };
    return all;
}

}  // namespace glint::rooms
