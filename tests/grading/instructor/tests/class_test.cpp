// A class is graded to the end whatever its students hand in, and goes on where it was stopped.
#include "tests/grading/class.hpp"

#include "framework/image/file.hpp"
#include "framework/math/error.hpp"
#include "tests/grading/jplag.hpp"

#include <doctest/doctest.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <csignal>
#include <sys/wait.h>
#include <thread>
#include <unistd.h>

namespace glint::grading {
namespace {

namespace fs = std::filesystem;
using namespace std::chrono_literals;

// Four students and one of whom there is only the name.
struct Class {
    fs::path path = fs::temp_directory_path() / ("glint_class_" + std::to_string(getpid()));
    ClassOrder order{{{"12_schlick"}, "", "course", "an unknown secret", SOURCE_FOLDER},
                     path / "in",
                     path / "out",
                     path / "roster.csv",
                     2};

    Class() {
        fs::remove_all(path);
        const fs::path right = fs::path(SOURCE_FOLDER) / "lessons/12_schlick/schlick.hpp";
        hand_in("ada", read_text(right));
        hand_in("bob <b>\x1b[2J", read_text(right));
        hand_in("eve", "#include <unistd.h>\n[[gnu::constructor]] static void f() { fork(); }\n" +
                           read_text(right));
        fs::create_directories(path / "in/link");
        fs::create_symlink("/etc/passwd", path / "in/link/schlick.hpp");
        write_text(path / "roster.csv", "student,name\nada,Ada\nzoe,Zoe\n");
    }
    ~Class() { fs::remove_all(path); }
    Class(const Class&) = delete;
    Class& operator=(const Class&) = delete;

    void hand_in(const std::string& student, const std::string& text) const {
        fs::create_directories(path / "in" / student);
        write_text(path / "in" / student / "schlick.hpp", text);
    }
    nlohmann::json report(const std::string& student) const {
        return nlohmann::json::parse(read_text(order.out / student / "report.json"));
    }
};

std::set<std::string> graded(const ClassOrder& order) {
    std::set<std::string> left = grade_class(order);
    left.merge(sum_up(order));
    return left;
}

TEST_CASE("everyone gets a grade") {
    const Class c;
    CHECK(graded(c.order).empty());
    CHECK(c.report("ada").at("earned") == 6);
    CHECK(c.report("bob <b>\x1b[2J").at("earned") == 6);
    CHECK(c.report("eve").at("lessons")[0].at("verdict") == "forbidden");
    CHECK(c.report("link").at("lessons")[0].at("verdict") == "rejected");
    CHECK(c.report("zoe").at("lessons")[0].at("verdict") == "skipped");
    const std::string grades = read_text(c.order.out / "grades.csv");
    CHECK(std::count(grades.begin(), grades.end(), '\n') == 6);
    CHECK(read_text(c.order.out / "statistics.csv").find("nobody") == std::string::npos);

    // What is graded stays; what changed is graded again.
    const auto written = fs::last_write_time(c.order.out / "ada/report.json");
    c.hand_in("eve", "none");
    grade_class(c.order);
    CHECK(fs::last_write_time(c.order.out / "ada/report.json") == written);
    CHECK(c.report("eve").at("lessons")[0].at("verdict") == "compile error");
}

TEST_CASE("a class that was killed goes on, in parts too, to the same grades") {
    const Class c;
    const pid_t child = fork();
    if (child == 0) {
        setsid();
        grade_class(c.order);
        _exit(0);
    }
    while (!fs::exists(c.order.out / "ada/report.json")) {
        std::this_thread::sleep_for(10ms);
    }
    kill(-child, SIGKILL);
    waitpid(child, nullptr, 0);
    CHECK(!fs::exists(c.order.out / "grades.csv"));
    ClassOrder part = c.order;
    part.parts = 2;
    for (part.part = 0; part.part < 2; ++part.part) {
        grade_class(part);
    }
    CHECK(graded(c.order).empty());
    const std::string grades = read_text(c.order.out / "grades.csv");
    CHECK(std::count(grades.begin(), grades.end(), '\n') == 6);
}

TEST_CASE("an internal error is no grade") {
    const Class c;
    ClassOrder broken = c.order;
    broken.order.root = c.path / "nowhere";
    const auto again = graded(broken);
    CHECK(again.size() == 3);  // who handed in what can be read
    CHECK(c.report("ada").at("final") == false);
    CHECK(graded(c.order).empty());
    CHECK(c.report("ada").at("earned") == 6);
}

TEST_CASE("a grade that cannot be made anew is not the old one") {
    const Class c;
    CHECK(graded(c.order).empty());
    c.hand_in("ada", "none");
    fs::remove(c.order.out / "ada/report.html");
    fs::create_directories(c.order.out / "ada/report.html");
    CHECK(grade_class(c.order) == std::set<std::string>{"ada"});
    CHECK(sum_up(c.order) == std::set<std::string>{"ada"});
    CHECK(read_text(c.order.out / "grades.csv").find("\"ada\"") == std::string::npos);
}

TEST_CASE("who names nothing that can be graded learns it, and gets no zero") {
    const Class c;
    const auto error = [&](const fs::path& submission) {
        try {
            require_submission(submission, c.order.order);
        } catch (const Error& e) {
            return std::string(e.what());
        }
        return std::string();
    };
    CHECK(error(c.path / "none").starts_with((c.path / "none").string() + ": is not there"));
    CHECK(error(c.path / "roster.csv").ends_with("none of schlick.hpp"));
    CHECK(error(c.path / "in/ada/schlick.hpp").empty());
    CHECK(error(c.path / "in/link/schlick.hpp").empty());  // there, though rejected
    CHECK(error(c.path / "in/ada").empty());
    write_text(c.path / "ada.ZIP", "");
    CHECK(error(c.path / "ada.ZIP").empty());
}

TEST_CASE("JPlag gets what was handed in, and what everyone was given") {
    Class c;
    const fs::path given = c.path / "given";
    fs::create_directories(given);
    write_text(given / "schlick.hpp", "// given\n");
    export_for_jplag(c.order, given);
    CHECK(read_text(c.order.out / "base/schlick.hpp") == "// given\n");
    CHECK(read_text(c.order.out / "submissions/ada/schlick.hpp") ==
          read_text(c.path / "in/ada/schlick.hpp"));
    const auto students = fs::directory_iterator(c.order.out / "submissions");
    CHECK(std::distance(begin(students), end(students)) == 3);  // links and names alone are none
    CHECK_THROWS_AS(export_for_jplag(c.order, given), Error);
    c.order.order.lessons = {"12_schlick", "13_specular_colour"};
    c.order.out = c.path / "elsewhere/";
    const auto before = std::distance(fs::directory_iterator(c.path), fs::directory_iterator());
    CHECK_THROWS_AS(export_for_jplag(c.order, given), Error);
    CHECK(std::distance(fs::directory_iterator(c.path), fs::directory_iterator()) == before);
    write_text(given / "specular_colour.hpp", "// given\n");
    export_for_jplag(c.order, given);
    CHECK(fs::exists(c.order.out / "submissions/ada/schlick.hpp"));
}

}  // namespace
}  // namespace glint::grading
