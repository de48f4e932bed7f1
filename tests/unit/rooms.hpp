// The include rule of the house, checked in the text of the sources.
#pragma once

#include <span>
#include <string>
#include <vector>

namespace glint::rooms {

struct Source {
    std::string path;  // from the root
    std::string text;
};

struct Include {
    int line;
    std::string header;
    bool quoted;  // "of the project", not <of a package>
};
std::vector<Include> includes_of(const std::string& text);

// One line for each include that the house does not allow: path:line: what, and why not.
//
// A room of framework/ includes itself and the rooms that allowed_rooms() names, a lesson
// framework/ and the headers of earlier lessons (a program of lessons/ without a number: of all
// lessons), nothing tests/, and each package only where package_places() says; tests may include
// anything. Headers of the project are named by their full path from the root.
std::vector<std::string> broken_rules(std::span<const Source> sources);

// The rooms below a room of framework/; empty for unknown rooms.
std::vector<std::string> allowed_rooms(const std::string& room);

// A package, by the beginning of its headers' names, and the files that may include it.
struct PackagePlaces {
    std::string header;
    std::vector<std::string> files;
};
std::span<const PackagePlaces> package_places();

}  // namespace glint::rooms
