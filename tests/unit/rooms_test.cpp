// The house as docs/contributing.md describes it: who includes whom.
#include "tests/unit/rooms.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <regex>
#include <set>
#include <sstream>

namespace glint::rooms {
namespace {

namespace fs = std::filesystem;

std::string text_of(const fs::path& path) {
    std::ifstream file(path, std::ios::binary);
    REQUIRE(file.good());
    std::ostringstream text;
    text << file.rdbuf();
    return text.str();
}

// All headers and sources of the project.
std::vector<Source> project() {
    std::vector<Source> all;
    const fs::path root = SOURCE_FOLDER;
    for (const char* folder : {"framework", "lessons", "tests"}) {
        for (const auto& entry : fs::recursive_directory_iterator(root / folder)) {
            const std::string kind = entry.path().extension().string();
            if (entry.is_regular_file() && (kind == ".hpp" || kind == ".cpp")) {
                all.push_back(
                    {fs::relative(entry.path(), root).generic_string(), text_of(entry.path())});
            }
        }
    }
    return all;
}

std::string joined(const std::vector<std::string>& lines) {
    std::string text;
    for (const std::string& line : lines) {
        text += line + '\n';
    }
    return text;
}

TEST_CASE("every include of the project keeps to the house's rule") {
    const auto sources = project();
    CHECK(sources.size() > 100);
    CHECK(joined(broken_rules(sources)) == "");
}

TEST_CASE("every header that is included is there") {
    const auto sources = project();
    std::set<std::string> known;
    for (const Source& s : sources) {
        known.insert(s.path);
    }
    std::vector<std::string> missing;
    for (const Source& s : sources) {
        for (const Include& i : includes_of(s.text)) {
            if (i.quoted && !s.path.starts_with("tests/") && !known.contains(i.header)) {
                missing.push_back(s.path + ": " + i.header);
            }
        }
    }
    CHECK(joined(missing) == "");
}

TEST_CASE("a source opens with the header of its name, which so is compiled alone") {
    const auto sources = project();
    std::set<std::string> known;
    for (const Source& s : sources) {
        known.insert(s.path);
    }
    std::vector<std::string> late;
    for (const Source& s : sources) {
        const std::string header = fs::path(s.path).replace_extension(".hpp").generic_string();
        if (s.path != header && known.contains(header) &&
            includes_of(s.text).front().header != header) {
            late.push_back(s.path);
        }
    }
    CHECK(joined(late) == "");
}

TEST_CASE("a package's list names no file that does not include it") {
    const auto sources = project();
    for (const PackagePlaces& package : package_places()) {
        for (const std::string& file : package.files) {
            CAPTURE(package.header);
            CAPTURE(file);
            const auto source = std::find_if(sources.begin(), sources.end(),
                                             [&](const Source& s) { return s.path == file; });
            REQUIRE(source != sources.end());
            const auto includes = includes_of(source->text);
            CHECK(std::any_of(includes.begin(), includes.end(), [&](const Include& i) {
                return !i.quoted && i.header.starts_with(package.header);
            }));
        }
    }
}

TEST_CASE("the rooms are linked as they are included") {
    std::set<std::string> seen;
    for (const auto& entry : fs::directory_iterator(fs::path(SOURCE_FOLDER) / "framework")) {
        if (!entry.is_directory()) {
            continue;
        }
        const std::string room = entry.path().filename().string();
        CAPTURE(room);
        seen.insert(room);
        const std::string text = text_of(entry.path() / "CMakeLists.txt");
        std::smatch match;
        const std::regex uses("glint_room\\(" + room + "\\b[^)]*USES([a-z\\s]*)\\)");
        REQUIRE(std::regex_search(text, match, uses));
        std::istringstream words(match[1]);
        for (std::string used; words >> used;) {
            CAPTURE(used);
            const auto allowed = allowed_rooms(room);
            const bool below = std::find(allowed.begin(), allowed.end(), used) != allowed.end();
            CHECK((below || used == "options"));
        }
    }
    CHECK(seen ==
          std::set<std::string>{"app", "geometry", "image", "math", "measure", "raster", "scene"});
}

std::string verdict(const std::string& path, const std::string& line) {
    const Source source{path, "// comment\n" + line + "\nint x;\n"};
    return joined(broken_rules(std::span(&source, 1)));
}

TEST_CASE("what is allowed passes") {
    const struct {
        const char *path, *line;
    } cases[] = {
        {"framework/math/lanes.hpp", "#include \"framework/math/simd.hpp\""},
        {"framework/math/lanes.hpp", "#include <glm/vec3.hpp>"},
        {"framework/math/registers.hpp", "#include <xsimd/xsimd.hpp>"},
        {"framework/raster/bins.cpp", "#include \"framework/geometry/mesh.hpp\""},
        {"framework/app/probe.cpp", "#include \"framework/measure/quadrature.hpp\""},
        {"framework/app/programs/compare.cpp", "#include <CLI/CLI.hpp>"},
        {"lessons/09_x/x.hpp", "#include \"lessons/08_y/y.hpp\""},
        {"lessons/09_x/main.cpp", "#include \"lessons/09_x/x.hpp\""},
        {"lessons/09_x/main.cpp", "#include \"framework/app/lesson.hpp\""},
        {"lessons/gonio/main.cpp", "#include \"lessons/18_z/z.hpp\""},
        {"tests/unit/a_test.cpp", "#include <xsimd/xsimd.hpp>"},
        {"tests/unit/a_test.cpp", "#include \"lessons/18_z/z.hpp\""},
        {"framework/math/a.hpp", "// #include \"framework/app/lesson.hpp\""},
        {"framework/math/a.hpp", "const char* s = \"#include <SDL.h>\";"},
    };
    for (const auto& c : cases) {
        CAPTURE(std::string(c.path));
        CAPTURE(std::string(c.line));
        CHECK(verdict(c.path, c.line) == "");
    }
}

TEST_CASE("what is not allowed is found, with its place and the reason") {
    const struct {
        const char *path, *line, *why;
    } cases[] = {
        {"framework/math/a.hpp", "#include \"framework/image/image.hpp\"", "below"},
        {"framework/image/a.cpp", "#include \"framework/geometry/mesh.hpp\"", "beside"},
        {"framework/raster/a.cpp", "#include \"framework/scene/light.hpp\"", "beside"},
        {"framework/scene/a.cpp", "#include \"framework/raster/shader.hpp\"", "beside"},
        {"framework/measure/a.hpp", "#include \"framework/image/image.hpp\"", "beside"},
        {"framework/raster/a.cpp", "  #  include \"framework/app/lesson.hpp\"", "below"},
        {"framework/raster/a.cpp", "#include \"lessons/09_x/x.hpp\"", "below"},
        {"framework/new_room/a.cpp", "#include \"framework/math/vec.hpp\"", "below"},
        {"framework/app/a.cpp", "#include \"tests/oracle/random.hpp\"", "tests"},
        {"lessons/09_x/x.hpp", "#include \"tests/oracle/random.hpp\"", "tests"},
        {"lessons/09_x/x.hpp", "#include \"lessons/10_y/y.hpp\"", "earlier"},
        {"lessons/09_x/x.hpp", "#include \"lessons/gonio/models.hpp\"", "no lesson"},
        {"framework/raster/a.cpp", "#include \"setup.hpp\"", "full path"},
        {"framework/raster/a.cpp", "#include \"../math/vec.hpp\"", "full path"},
        {"framework/math/lanes.hpp", "#include <xsimd/xsimd.hpp>", "own file"},
        {"framework/app/probe.cpp", "#include <nlohmann/json.hpp>", "own file"},
        {"framework/app/text.cpp", "#include <stb/stb_image.h>", "own file"},
        {"lessons/01_x/main.cpp", "#include <CLI/CLI.hpp>", "own file"},
        {"framework/geometry/mtl.cpp", "#include <tiny_obj_loader.h>", "own file"},
        {"framework/app/options.cpp", "#include <SDL2/SDL.h>", "own file"},
        {"framework/math/a.cpp", "#include <doctest/doctest.h>", "own file"},
    };
    for (const auto& c : cases) {
        CAPTURE(std::string(c.path));
        CAPTURE(std::string(c.line));
        const std::string told = verdict(c.path, c.line);
        CHECK(told.starts_with(std::string(c.path) + ":2: includes "));
        CHECK(told.find(c.why) != std::string::npos);
    }
}

}  // namespace
}  // namespace glint::rooms
