#include "tests/grading/submission.hpp"

#include "framework/image/file.hpp"
#include "framework/math/error.hpp"
#include "tests/grading/archive.hpp"
#include "tests/grading/digest.hpp"
#include "tests/grading/doctor.hpp"
#include "tests/grading/grade_lesson.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <regex>
#include <set>
#include <sstream>

namespace glint::grading {
namespace {

struct Submitted {
    std::string lesson;
    Intake header;
};

// The headers of lessons that a header includes, directly or by another one.
std::set<std::string> included_by(const std::string& header, const std::filesystem::path& root) {
    static const std::regex include(R"re(#include "(lessons/[^"]+)".*)re");
    std::set<std::string> found;
    std::vector<std::string> unread{header};
    while (!unread.empty()) {
        std::istringstream lines(read_text(root / unread.back()));
        unread.pop_back();
        for (std::string line; std::getline(lines, line);) {
            std::smatch match;
            if (std::regex_match(line, match, include) &&
                std::filesystem::exists(root / match[1].str()) && found.insert(match[1]).second) {
                unread.push_back(match[1]);
            }
        }
    }
    return found;
}

std::vector<Submitted> collect(const std::filesystem::path& submission, const Order& order) {
    std::vector<Submitted> all;
    for (const std::string& name : graded_lessons()) {
        const bool ordered =
            std::find(order.lessons.begin(), order.lessons.end(), name) != order.lessons.end();
        if (!ordered && !order.lessons.empty()) {
            continue;
        }
        Intake header = find_header(submission, cases_of(name, std::nullopt));
        if (ordered || header.text || !header.objection.empty()) {
            all.push_back({name, std::move(header)});
        }
    }
    return all;
}

std::string hash_of(const std::vector<Submitted>& all) {
    std::string text;
    for (const Submitted& s : all) {
        text += s.lesson + '\n' + sha256(s.header.text.value_or(s.header.objection)) + '\n';
    }
    return sha256(text);
}

}  // namespace

std::string lesson_named(const std::string& word) {
    for (const std::string& name : graded_lessons()) {
        if (name == word || name.substr(0, 2) == word || name.substr(0, 2) == '0' + word) {
            return name;
        }
    }
    throw Error("lesson " + word + " is not graded");
}

std::string read_secret(const std::filesystem::path& file) {
    if (!is_protected(protections())) {
        throw Error("hidden cases are not run on this machine; grade doctor says what is missing");
    }
    std::string secret = read_text(file);
    if (secret.size() < 16) {
        throw Error(file.string() + ": a secret has 16 bytes or more");
    }
    return secret;
}

// Once, however many submissions are graded.
std::string bundle_hash() {
    static const std::string hash = [] {
        std::string text = read_text("/proc/self/exe");
        for (const std::string& name : graded_lessons()) {
            text += nlohmann::json(cases_of(name, std::nullopt)).dump();
        }
        return sha256(text);
    }();
    return hash;
}

std::string submission_hash(const std::filesystem::path& submission, const Order& order) {
    return hash_of(collect(submission, order));
}

std::string seed_of(const Order& o) {
    return o.secret.empty() ? "" : std::to_string(seed(o.secret, o.assignment + '\n' + o.student));
}

std::vector<std::string> unsolved_before(const std::string& lesson,
                                         const std::filesystem::path& root) {
    const auto header_of = [](const Lesson& l) { return "lessons/" + l.name + '/' + l.header; };
    const auto included = included_by(header_of(cases_of(lesson, std::nullopt)), root);
    std::vector<std::string> unsolved;
    for (const std::string& name : graded_lessons()) {
        const bool is_included = std::any_of(
            included.begin(), included.end(),
            [&](const std::string& header) { return header.starts_with("lessons/" + name + "/"); });
        if (name != lesson && is_included) {
            const Lesson before = cases_of(name, std::nullopt);
            const LessonResult r = grade_lesson(before, take_in(root, header_of(before)), root);
            if (r.earned() < r.points()) {
                unsolved.push_back(name);
            }
        }
    }
    return unsolved;
}

void require_submission(const std::filesystem::path& submission, const Order& order) {
    const auto status = std::filesystem::symlink_status(submission);
    if (!std::filesystem::exists(status)) {
        throw Error(submission.string() +
                    ": is not there; name a header, a folder or a zip archive");
    }
    if (std::filesystem::is_directory(status) || is_archive(submission)) {
        return;
    }
    std::string headers;
    for (const std::string& lesson : order.lessons.empty() ? graded_lessons() : order.lessons) {
        const std::string header = cases_of(lesson, std::nullopt).header;
        if (submission.filename() == header) {
            return;
        }
        headers += ' ' + header;
    }
    throw Error(submission.string() + ": is no folder, no zip archive and none of" + headers);
}

Report grade_submission(const std::filesystem::path& submission, const Order& order) {
    const std::vector<Submitted> all = collect(submission, order);
    Report report{order.student, order.assignment, hash_of(all), bundle_hash(), seed_of(order), {}};
    const auto identity =
        order.secret.empty()
            ? std::nullopt
            : std::optional<Identity>({order.secret, order.assignment, order.student});
    for (const Submitted& s : all) {
        report.lessons.push_back(grade_lesson(cases_of(s.lesson, identity), s.header, order.root));
    }
    return report;
}

}  // namespace glint::grading
