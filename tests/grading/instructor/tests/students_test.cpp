// Who is in a class is read off names that anyone may have chosen.
#include "tests/grading/students.hpp"

#include "framework/image/file.hpp"
#include "framework/math/error.hpp"
#include "tests/temporary.hpp"

#include <doctest/doctest.h>

namespace glint::grading {
namespace {

namespace fs = std::filesystem;

struct HandedIn {
    TemporaryFolder scratch;
    fs::path folder = scratch / "in", roster = scratch / "roster.csv";

    HandedIn() { fs::create_directories(folder / "ada"); }

    std::vector<std::string> names() const {
        std::vector<std::string> all;
        for (const Student& s : students_of(folder, fs::exists(roster) ? roster : fs::path())) {
            all.push_back(s.name);
        }
        return all;
    }
    std::string error() const {
        try {
            names();
        } catch (const Error& e) {
            return e.what();
        }
        return "";
    }
};

using Names = std::vector<std::string>;

TEST_CASE("no name leads out of the folder for reports, or to what else lies there") {
    const HandedIn in;
    CHECK(in.names() == Names{"ada"});
    for (const std::string name : {"../escape", "/tmp/escape", "..", "a/b", "slurm"}) {
        write_text(in.roster, name + ",x\n");
        CHECK(in.error().starts_with(in.roster.string() + ":1: no student can be called '" + name));
    }
    fs::remove(in.roster);
    for (const char* name : {"...zip", "..zip", "grades.csv.zip"}) {
        write_text(in.folder / name, "");
        CHECK(in.error().starts_with((in.folder / name).string() + ": no student"));
        fs::remove(in.folder / name);
    }
    for (const char* name : {"grades.csv", "statistics.csv", "slurm"}) {
        fs::create_directory(in.folder / name);
        CHECK(in.error().starts_with((in.folder / name).string() + ": no student"));
        fs::remove(in.folder / name);
    }
}

TEST_CASE("nothing that was handed in is passed over in silence") {
    const HandedIn in;
    for (const char* name : {"bob.ZIP", "carl.hpp", "dora.tar.gz"}) {
        write_text(in.folder / name, "");
    }
    fs::create_symlink(in.folder / "ada", in.folder / "link");
    CHECK(in.names() == Names{"ada", "bob"});
    CHECK(not_taken(in.folder) == std::set<fs::path>{in.folder / "carl.hpp",
                                                     in.folder / "dora.tar.gz",
                                                     in.folder / "link"});
    write_text(in.folder / "ada.zip", "");
    CHECK(in.error().find((in.folder / "ada").string()) != std::string::npos);
    CHECK(in.error().find((in.folder / "ada.zip").string()) != std::string::npos);
}

TEST_CASE("rosters are read as programs write them") {
    const HandedIn in;
    const auto names = [&](const char* roster) {
        write_text(in.roster, roster);
        return in.names();
    };
    CHECK(names("student,name\nada,Ada\n\nbob") == Names{"ada", "bob"});
    CHECK(names("ada\nbob\n") == Names{"ada", "bob"});
    CHECK(names("\xef\xbb\xbfstudent,name\r\nbob,Bob\r\n\r\n") == Names{"ada", "bob"});
    CHECK(names("\xef\xbb\xbf\"student\",\"name\"\r\n\"bob\",\"Bob\"\r\n") == Names{"ada", "bob"});
    CHECK(names("Student\n\"Doe, Jane\",2\n\"o\"\"neil\"\n") ==
          Names{"Doe, Jane", "ada", "o\"neil"});
    CHECK(names("student;name\nbob;Bob, or Robert\n") == Names{"ada", "bob"});
    CHECK(names("student,name\nbob;y,Bob\n") == Names{"ada", "bob;y"});
}

TEST_CASE("rosters that cannot be read are refused") {
    const HandedIn in;
    write_text(in.roster, "student\n\"bob,Bob\n");
    CHECK(in.error().starts_with(in.roster.string() + ":2: a quote"));
    write_text(in.roster,
               "\xff\xfe"
               "b");
    CHECK(in.error().starts_with(in.roster.string() + ": is not in UTF-8"));
}

TEST_CASE("what is written lies elsewhere than what was handed in") {
    const HandedIn in;
    fs::create_directory_symlink(in.folder, in.scratch / "link");
    for (const fs::path& out :
         {in.folder, in.folder / "out", in.folder / "ada/../new/out", in.scratch / "link/out"}) {
        CHECK_THROWS_AS(require_outside(in.folder, out), Error);
    }
    for (const fs::path& out : {in.scratch / "out", in.scratch / "in2", in.folder / "../out"}) {
        CHECK_NOTHROW(require_outside(in.folder, out));
    }
    CHECK_NOTHROW(require_outside(in.folder, "not_there/out"));
}

}  // namespace
}  // namespace glint::grading
