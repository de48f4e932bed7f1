#include "tests/grading/intake.hpp"

#include "framework/image/file.hpp"
#include "tests/grading/archive.hpp"
#include "tests/grading/grade_lesson.hpp"
#include "tests/grading/plain_text.hpp"

#include <doctest/doctest.h>

#include <cstdlib>
#include <filesystem>
#include <sys/resource.h>
#include <sys/stat.h>
#include <unistd.h>

namespace glint::grading {
namespace {

namespace fs = std::filesystem;

struct Folder {
    fs::path path = fs::temp_directory_path() / ("glint_intake_" + std::to_string(getpid()));
    Folder() { fs::create_directories(path / "sub"); }
    ~Folder() { fs::remove_all(path); }
    Folder(const Folder&) = delete;
    Folder& operator=(const Folder&) = delete;
};

std::string objection(const fs::path& folder, const fs::path& below) {
    const Intake taken = take_in(folder, below);
    CHECK(!taken.text);
    return taken.objection;
}

TEST_CASE("a text file is taken in") {
    const Folder f;
    write_text(f.path / "a.hpp", "int x;  // \xc3\xa4\n");
    write_text(f.path / "sub/a.hpp", "");
    CHECK(take_in(f.path, "a.hpp").text == "int x;  // \xc3\xa4\n");
    CHECK(take_in(f.path / "a.hpp", "").text == "int x;  // \xc3\xa4\n");
    CHECK(take_in(f.path, "sub/a.hpp").text == "");
    write_text(f.path / "large", std::string(largest_submission, 'x'));
    CHECK(take_in(f.path, "large").text->size() == largest_submission);
}

TEST_CASE("what is not there is no offence") {
    const Folder f;
    CHECK(objection(f.path, "a.hpp").empty());
    CHECK(objection(f.path, "lessons/12/a.hpp").empty());
    CHECK(objection(f.path / "none", "a.hpp").empty());
}

TEST_CASE("links, devices, pipes, folders, large and binary files are refused") {
    const Folder f;
    write_text(f.path / "secret", "s");
    fs::create_symlink(f.path / "secret", f.path / "link");
    fs::create_symlink("/dev/zero", f.path / "endless");
    fs::create_directory_symlink(f.path, f.path / "round");
    fs::create_hard_link(f.path / "secret", f.path / "second");
    REQUIRE(mkfifo((f.path / "fifo").c_str(), 0600) == 0);
    CHECK(objection(f.path, "link") == "a link");
    CHECK(objection(f.path, "endless") == "a link");
    CHECK(take_in(f.path, "round/secret").text == std::nullopt);
    CHECK(objection(f.path, "second") == "a file with a second name");
    CHECK(objection(f.path, "fifo") == "not a regular file");
    CHECK(objection(f.path, "sub") == "not a regular file");
    CHECK(objection("/dev", "zero") == "not a regular file");
    write_text(f.path / "large", std::string(largest_submission + 1, 'x'));
    CHECK(objection(f.path, "large") == "larger than 256 kB");
    fs::resize_file(f.path / "large", std::uintmax_t{1} << 40);  // with holes
    CHECK(objection(f.path, "large") == "larger than 256 kB");
    write_text(f.path / "binary", std::string("a\0b", 3));
    CHECK(objection(f.path, "binary") == "not a text in UTF-8");
    write_text(f.path / "latin", "\xe4");
    CHECK(objection(f.path, "latin") == "not a text in UTF-8");
}

TEST_CASE("what the grader cannot read is its own fault, not the student's") {
    const Folder f;
    write_text(f.path / "a.hpp", "int x;\n");
    rlimit files{};
    getrlimit(RLIMIT_NOFILE, &files);
    const rlimit none{0, files.rlim_max};
    setrlimit(RLIMIT_NOFILE, &none);
    const Intake taken = take_in(f.path, "a.hpp");
    setrlimit(RLIMIT_NOFILE, &files);
    CHECK(taken.is_ours);
    CHECK(taken.objection == "cannot be read: Too many open files");
    const LessonResult r = grade_lesson(Lesson{"12_schlick", "schlick.hpp", {}}, taken, f.path);
    CHECK(r.verdict == Verdict::internal_error);

    REQUIRE(mknod((f.path / "socket").c_str(), S_IFSOCK | 0600, 0) == 0);
    CHECK(objection(f.path, "socket") == "not a regular file");
    CHECK(!take_in(f.path, "socket").is_ours);
    CHECK(!take_in(f.path, "none.hpp").is_ours);
}

TEST_CASE("a header is taken out of an archive, and nothing else is") {
    if (std::system("command -v zip >/dev/null && command -v unzip >/dev/null") != 0) {
        return;
    }
    const Folder f;
    const auto zip = [&](const std::string& name, const std::string& members) {
        const std::string command = "cd " + f.path.string() + " && zip -q " + name + ' ' + members;
        REQUIRE(std::system(command.c_str()) == 0);
        return take_from_archive(f.path / name, "a.hpp");
    };
    write_text(f.path / "sub/a.hpp", "int x;\n");
    write_text(f.path / "b.hpp", "int y;\n");
    CHECK(zip("one.zip", "sub/a.hpp b.hpp").text == "int x;\n");
    fs::copy_file(f.path / "one.zip", f.path / "ONE.ZIP");
    CHECK(find_header(f.path / "ONE.ZIP", Lesson{"", "a.hpp", {}}).text == "int x;\n");
    fs::create_directory(f.path / "many");
    const std::string long_name(200, 'x');
    for (int i = 0; i < 2000; ++i) {
        write_text(f.path / "many" / (long_name + std::to_string(i)), "");
    }
    CHECK(zip("many.zip", "-r many sub/a.hpp").text == "int x;\n");
    CHECK(zip("others.zip", "-r many").objection.empty());
    CHECK(zip("none.zip", "b.hpp").objection.empty());
    write_text(f.path / "a.hpp", "int z;\n");
    CHECK(zip("two.zip", "a.hpp sub/a.hpp").objection.starts_with("more than one"));
    write_text(f.path / "a.hpp", std::string(std::size_t{1} << 26, ' '));
    CHECK(zip("bomb.zip", "a.hpp").objection == "larger than 256 kB");
    fs::remove(f.path / "a.hpp");
    fs::create_symlink("/etc/passwd", f.path / "a.hpp");
    CHECK(zip("link.zip", "-y a.hpp").text == "/etc/passwd");  // the link's own text
    write_text(f.path / "broken.zip", "PK");
    CHECK(take_from_archive(f.path / "broken.zip", "a.hpp").objection ==
          "an archive that cannot be read");
    fs::create_symlink(f.path / "one.zip", f.path / "link");
    CHECK(take_from_archive(f.path / "link", "a.hpp").objection.starts_with("no archive"));
}

TEST_CASE("words of strangers are made printable") {
    CHECK(printable("plain\n\ttext \xc3\xa4 \xe2\x82\xac", 100) ==
          "plain\n\ttext \xc3\xa4 \xe2\x82\xac");
    CHECK(printable("\x1b[31m\a\x7f\r", 100) == "?[31m???");
    // NOLINTNEXTLINE(misc-misleading-bidirectional): that is what it is about
    CHECK(printable("\xc2\x9b"
                    "31m \xe2\x81\xa6"
                    "x",
                    100) == "?31m ?x");
    CHECK(printable("\xff\xc0\x80\xed\xa0\x80", 100) == "??????");
    CHECK(printable("abcdef", 3) == "abc...");
    CHECK(printable("ab\xe2\x82\xac", 4) == "ab...");
}

TEST_CASE("UTF-8 is told from what is not") {
    CHECK(is_plain_text(""));
    CHECK(is_plain_text("\xf0\x9f\x98\x80\xef\xbb\xbf"));
    for (const char* wrong : {"\x80", "\xc3", "\xc0\xaf", "\xe0\x80\xaf", "\xed\xa0\x80",
                              "\xf4\x90\x80\x80", "\xf8\x88\x80\x80\x80"}) {
        CHECK(!is_plain_text(wrong));
    }
}

}  // namespace
}  // namespace glint::grading
