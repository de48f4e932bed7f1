// Hostile submissions get the verdicts they deserve, honest ones are not hurt, and nothing is left
// of either.
#include "tests/grading/instructor/tests/submissions.hpp"

#include "framework/image/file.hpp"
#include "tests/grading/cases.hpp"
#include "tests/grading/doctor.hpp"
#include "tests/grading/instructor/marks.hpp"
#include "tests/grading/sandbox/confine.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <iostream>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

namespace glint::grading {
namespace {

namespace fs = std::filesystem;

std::vector<Submission> everyone() {
    std::vector<Submission> all = read_submissions("hostile.txt");
    const std::vector<Submission> honest = read_submissions("honest.txt");
    all.insert(all.end(), honest.begin(), honest.end());
    return all;
}

bool is_slow(const Submission& s) {
    return s.verdict == "timeout" || s.verdict == "compile limit";
}

// A temporary folder of this test's own.
struct Scratch {
    fs::path path = fs::temp_directory_path() / ("glint_submissions_" + std::to_string(getpid()));
    Scratch() {
        fs::create_directory(path);
        setenv("TMPDIR", path.c_str(), 1);
    }
    ~Scratch() {
        unsetenv("TMPDIR");
        fs::remove_all(path);
    }
    Scratch(const Scratch&) = delete;
    Scratch& operator=(const Scratch&) = delete;
};

// Processes of the user that is there for submissions, folders of workshops, files in /tmp that
// some submissions try to write.
std::vector<std::string> leftovers() {
    std::vector<std::string> left;
    for (const auto& entry : fs::directory_iterator("/proc")) {
        struct stat info {};
        if (stat(entry.path().c_str(), &info) == 0 && info.st_uid == nobodys_user()) {
            left.push_back(entry.path());
        }
    }
    for (const auto& entry : fs::directory_iterator(fs::temp_directory_path())) {
        left.push_back(entry.path());
    }
    for (const char* file : {"/tmp/here", "/tmp/results.json"}) {
        if (fs::exists(file)) {
            left.emplace_back(file);
        }
    }
    return left;
}

TEST_CASE("every submission gets its verdict, and the points that are due") {
    REQUIRE(is_protected(protections()));
    const Scratch scratch;
    const auto all = everyone();
    CHECK(all.size() >= 60);
    for (const Submission& s : all) {
        CAPTURE(s.words);
        const LessonResult r = graded(s);
        CAPTURE(r.words);
        CHECK(std::string(name_of(r.verdict)) == s.verdict);
        const bool by_heart = s.words == "knows the visible cases by heart";
        CHECK(r.earned() == (s.verdict == "ok" ? r.points() : by_heart ? 1 : 0));
        for (const char* leak : {"\x1b", "root:", "SECRET"}) {
            CHECK(r.words.find(leak) == std::string::npos);
        }
    }
    CHECK(leftovers().empty());
}

constexpr std::size_t workers_at_a_time = 3;

// In a process of its own: how many of this worker's submissions, from the last, were judged
// otherwise. Half of all are enough.
int misjudged(std::vector<Submission> all, std::size_t worker) {
    std::reverse(all.begin(), all.end());
    int count = 0;
    for (std::size_t i = worker; i < all.size(); i += 2 * workers_at_a_time) {
        if (!is_slow(all[i]) && name_of(graded(all[i]).verdict) != all[i].verdict) {
            std::clog << "in parallel, judged otherwise: " << all[i].words << '\n';
            ++count;
        }
    }
    return count;
}

TEST_CASE("the verdicts are the same in another order and in parallel") {
    const auto all = everyone();
    std::vector<pid_t> workers;
    for (std::size_t i = 0; i < workers_at_a_time; ++i) {
        workers.push_back(fork());
        if (workers.back() == 0) {
            _exit(std::min(misjudged(all, i), 100));
        }
    }
    for (const pid_t worker : workers) {
        int status = 0;
        REQUIRE(waitpid(worker, &status, 0) == worker);
        CHECK(status == 0);
    }
}

TEST_CASE("what lanes do to each other is wrong, though right for one number") {
    const fs::path root = SOURCE_FOLDER;
    const std::string header = "lessons/09_normalised_phong/normalised_phong.hpp";
    const auto regions = read_marks(header, read_text(root / header));
    const std::string text =
        with_answer(regions, "09.2",
                    {"    if (any(v_dot_r(g) <= T(0.0F))) {", "        return T(0.0F);", "    }",
                     "    return phong_normalisation(n) * phong_lobe(g, n);"});
    const LessonResult r = grade_lesson(
        cases_of("09_normalised_phong", Identity{"an unknown secret", "", ""}), {text, ""}, root);
    CAPTURE(r.words);
    CHECK(r.verdict == Verdict::wrong);
    CHECK(r.tasks.at(0).earned() == r.tasks.at(0).points());
    for (const CaseResult& c : r.tasks.at(1).cases) {
        CAPTURE(c.name);
        const bool asks_all_around = c.name == "reflects less aslant";
        CHECK((c.verdict == Verdict::wrong) == asks_all_around);
        CHECK((c.words.find("lane") != std::string::npos) == asks_all_around);
    }
}

}  // namespace
}  // namespace glint::grading
