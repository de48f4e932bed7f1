// What students get, looked through for what they shall not.
#include "tests/grading/instructor/handout.hpp"

#include "framework/image/file.hpp"
#include "framework/math/error.hpp"
#include "tests/grading/case.hpp"
#include "tests/grading/cases.hpp"

#include <doctest/doctest.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cstdlib>
#include <regex>
#include <unistd.h>

namespace glint::grading {
namespace {

namespace fs = std::filesystem;

struct Scratch {
    fs::path path = fs::temp_directory_path() / ("glint_handout_" + std::to_string(::getpid()));
    Scratch() { fs::create_directory(path); }
    ~Scratch() { fs::remove_all(path); }
    Scratch(const Scratch&) = delete;
    Scratch& operator=(const Scratch&) = delete;
};

// Links in Markdown to what is not there, as FILE: LINK.
std::vector<std::string> dead_links(const fs::path& tree) {
    static const std::regex link(R"(\]\(([\w./-]+)(#[\w-]*)?\))");
    std::vector<std::string> dead;
    for (const auto& entry : fs::recursive_directory_iterator(tree)) {
        if (entry.path().extension() != ".md") {
            continue;
        }
        const std::string text = read_text(entry.path());
        for (std::sregex_iterator match(text.begin(), text.end(), link), end; match != end;
             ++match) {
            if (!fs::exists(entry.path().parent_path() / match->str(1))) {
                dead.push_back(entry.path().string() + ": " + match->str(1));
            }
        }
    }
    return dead;
}

TEST_CASE("the handout holds no line of an answer, no hidden case, nothing of the instructor's") {
    const Scratch scratch;
    const fs::path tree = scratch.path / "course";
    hand_out(SOURCE_FOLDER, tree);

    const auto lines = telling_lines(SOURCE_FOLDER);
    CHECK(lines.size() > 40);
    int files = 0;
    for (const auto& entry : fs::recursive_directory_iterator(tree)) {
        if (!entry.is_regular_file()) {
            continue;
        }
        ++files;
        const std::string path = fs::relative(entry.path(), tree).generic_string();
        const std::string text = read_text(entry.path());
        CAPTURE(path);
        for (const std::string& line : lines) {
            if (text.find(line) != std::string::npos) {
                CAPTURE(line);
                FAIL_CHECK("holds a line of an answer");
            }
        }
        CHECK(text.find("// SOLUTION ") == std::string::npos);
    }
    CHECK(files > 200);
    CHECK(dead_links(tree) == std::vector<std::string>{});
    CHECK(!fs::exists(tree / "tests/grading/instructor"));
    CHECK(!fs::exists(tree / "tests/unit/lessons"));
    CHECK(!fs::exists(tree / ".git"));
    CHECK(fs::exists(tree / "lessons/09_normalised_phong/normalised_phong.hpp"));

    for (const std::string& name : graded_lessons()) {
        Lesson lesson;
        nlohmann::json::parse(read_text(tree / "tests/grading/cases" / (name + ".json")))
            .get_to(lesson);
        for (const Task& task : lesson.tasks) {
            CHECK(!task.cases.empty());
            for (const Case& c : task.cases) {
                CHECK(!c.hidden);
            }
        }
    }
}

TEST_CASE("a folder that is not empty is left alone") {
    const Scratch scratch;
    write_text(scratch.path / "mine", "x");
    CHECK_THROWS_AS(hand_out(SOURCE_FOLDER, scratch.path), Error);
    CHECK(read_text(scratch.path / "mine") == "x");
}

void shell(const std::string& command) {
    REQUIRE(std::system(command.c_str()) == 0);
}

TEST_CASE("only what git knows is handed out, and neighbours are left alone") {
    const Scratch scratch;
    const fs::path tree = scratch.path / "tree";
    fs::create_directories(tree / "tests/grading/instructor");
    write_text(tree / "tests/grading/instructor/paths.txt", "# not these\ntests\n");
    write_text(tree / "README.md", "[a](tests/x) [b](kept.txt)\n```\n[a](tests/x)\n```\n");
    write_text(tree / "kept.txt", "x");
    CHECK_THROWS_WITH_AS(hand_out(tree, scratch.path / "none"), doctest::Contains("git"), Error);
    CHECK(!fs::exists(scratch.path / "none"));
    shell("cd '" + tree.string() + "' && git init -q . && git add .");
    write_text(tree / "secret", "x");
    write_text(tree / "answer.hpp~", "x");
    write_text(scratch.path / "course.new", "x");

    hand_out(tree, scratch.path / "course/");
    const fs::path course = scratch.path / "course";
    CHECK(read_text(course / "README.md") == "a [b](kept.txt)\n```\n[a](tests/x)\n```\n");
    CHECK(fs::exists(course / "kept.txt"));
    CHECK(!fs::exists(course / "secret"));
    CHECK(!fs::exists(course / "answer.hpp~"));
    CHECK(!fs::exists(course / "tests/grading/instructor"));
    CHECK(read_text(scratch.path / "course.new") == "x");
    const fs::directory_iterator all(scratch.path);
    CHECK(std::distance(begin(all), end(all)) == 3);
}

TEST_CASE("a task's points are its lesson's table's, and properties stand beside values") {
    for (const std::string& name : graded_lessons()) {
        const fs::path folder = fs::path(SOURCE_FOLDER) / "lessons" / name;
        const std::string text = read_text(folder / "README.md");
        const Lesson lesson = cases_of(name, Identity{"secret", "course", "somebody"});
        for (const Task& task : lesson.tasks) {
            CAPTURE(task.id);
            double points = 0;
            for (const Case& c : task.cases) {
                points += c.points;
                CHECK((!c.is_property() ||
                       std::any_of(task.cases.begin(), task.cases.end(), [&](const Case& other) {
                           return !other.is_property() && other.hidden == c.hidden;
                       })));
            }
            std::smatch match;
            REQUIRE(
                std::regex_search(text, match, std::regex("\\| " + task.id + " \\| (\\d+) \\|")));
            CHECK(points == std::stod(match[1]));
        }
    }
}

TEST_CASE("hidden cases differ by student, assignment and secret; visible ones never") {
    const auto questions = [](const Identity& who, bool hidden) {
        std::vector<double> all;
        for (const Task& task : cases_of("09_normalised_phong", who).tasks) {
            for (const Case& c : task.cases) {
                if (c.hidden == hidden && c.kind == "values") {
                    all.insert(all.end(), c.batches[0].questions.begin(),
                               c.batches[0].questions.end());
                }
            }
        }
        return all;
    };
    const Identity one{"secret", "course", "one"};
    for (const Identity& other :
         {Identity{"secret", "course", "two"}, Identity{"secret", "later course", "one"},
          Identity{"another", "course", "one"}}) {
        CHECK(questions(one, true) != questions(other, true));
        CHECK(questions(one, false) == questions(other, false));
    }
    CHECK(questions(one, true) == questions(one, true));
}

}  // namespace
}  // namespace glint::grading
