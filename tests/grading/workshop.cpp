#include "tests/grading/workshop.hpp"

#include "framework/image/file.hpp"
#include "tests/grading/plain_text.hpp"
#include "tests/grading/runner/wire.hpp"
#include "tests/grading/sandbox/confine.hpp"

#include <algorithm>
#include <csignal>
#include <cstring>
#include <numeric>
#include <random>
#include <regex>
#include <sstream>
#include <stdexcept>
#include <unistd.h>

namespace glint::grading {
namespace {

namespace fs = std::filesystem;
using namespace std::chrono_literals;

constexpr Limits compile_limits{10s, 30s, 2048 * MB, 64 * MB, 16 * MB, 0, 64 * KB};
constexpr Limits run_limits{2s, 6s, 512 * MB, 8 * MB, 0, 16 * MB, 256 * KB};

void copy_headers(const fs::path& root, const fs::path& folder, const fs::path& to) {
    for (const auto& entry : fs::recursive_directory_iterator(root / folder)) {
        if (entry.is_regular_file() && entry.path().extension() == ".hpp") {
            const fs::path file = to / fs::relative(entry.path(), root);
            fs::create_directories(file.parent_path());
            fs::copy_file(entry.path(), file);
        }
    }
}

bool asks_lanes(const Lesson& lesson) {
    for (const Task& task : lesson.tasks) {
        for (const Case& c : task.cases) {
            for (const Batch& b : c.batches) {
                if (b.number == "lanes") {
                    return true;
                }
            }
        }
    }
    return false;
}

// The students' side of the runner. The lesson's header comes last, so that its macros reach
// nothing but itself and the questions.
std::string answers_source(const Lesson& lesson) {
    const bool lanes = asks_lanes(lesson);
    std::string source = std::string(lanes ? "#include \"framework/math/lanes.hpp\"\n" : "") +
                         "#include \"tests/grading/runner/question.hpp\"\n"
                         "#include \"tests/grading/runner/wire.hpp\"\n"
                         "#include \"lessons/" +
                         lesson.name + "/" + lesson.header +
                         "\"\nnamespace glint {\n#include \"tests/grading/questions/" +
                         lesson.name + R"(.hpp"
template <Real T>
void answer_row(const grading::Request& asked, const double* in, std::size_t row, double* out) {
    answer<T>(static_cast<int>(asked.task), In<T>(in, asked.rows, asked.columns, row),
              Out<T>(out, row));
}
}
void glint_answer(const glint::grading::Request& asked, const double* in, std::size_t row,
                  double* out) {
    using glint::grading::Number;
    switch (asked.number) {
        case Number::as_double: return glint::answer_row<double>(asked, in, row, out);
        case Number::as_float: return glint::answer_row<float>(asked, in, row, out);
)";
    if (lanes) {
        source +=
            "        case Number::as_lanes:\n"
            "            return glint::answer_row<glint::Float<4>>(asked, in, row, out);\n";
    }
    return source + "        default: return;\n    }\n}\n";
}

Number number_of(const Batch& batch) {
    return batch.number == "double"  ? Number::as_double
           : batch.number == "float" ? Number::as_float
                                     : Number::as_lanes;
}

Program compiler(std::vector<std::string> arguments) {
    return {GLINT_COMPILER,
            std::move(arguments),
            {"PATH=/usr/bin:/bin", "LC_ALL=C.UTF-8", "TMPDIR=."},
            ""};
}

Confinement compiling(const fs::path& folder) {
    return {Calls::compiling, compile_limits,
            Reach{{"/usr", "/lib", "/lib64", folder / "include", folder / "student",
                   folder / "runner.o"},
                  {folder / "work", "/dev/null"}},
            nobodys_user(), folder / "work"};
}

bool has(const std::string& text, std::initializer_list<const char*> words) {
    return std::any_of(words.begin(), words.end(),
                       [&](const char* w) { return text.find(w) != std::string::npos; });
}

// Errors first; paths as the student knows them.
std::string first_errors(const std::string& diagnostics) {
    std::istringstream lines(diagnostics);
    std::string errors;
    for (std::string line; std::getline(lines, line);) {
        if (has(line, {"error", "Error:", "undefined reference", "multiple definition"})) {
            for (const std::string_view ours : {"../student/", "../include/"}) {
                for (std::size_t at = line.find(ours); at != std::string::npos;
                     at = line.find(ours, at)) {
                    line.erase(at, ours.size());
                }
            }
            errors += line + '\n';
        }
    }
    return printable(errors, 2 * KB);
}

Compiled failed_compilation(const Ended& e, Verdict otherwise) {
    const bool limit =
        e.how == Ended::How::out_of_time || e.how == Ended::How::output_limit ||
        e.how == Ended::How::signalled ||
        has(e.diagnostics, {"memory exhausted", "out of memory", "terminated program",
                            "Killed signal", "File too large", "file size limit", "bad_alloc"});
    return limit ? Compiled{Verdict::compile_limit,
                            "the compiler ran out of time, memory or room for its output"}
                 : Compiled{otherwise, first_errors(e.diagnostics)};
}

std::string signal_words(int signal) {
    const char* name = sigabbrev_np(signal);
    return name == nullptr ? "a signal" : std::string("SIG") + name;
}

Answered bad_end(Verdict verdict, const std::string& words, double seconds) {
    return {verdict, {}, words, seconds};
}

// What became of a runner that was to write so many bytes.
Answered judge_end(const Ended& e, std::size_t expected) {
    if (e.how == Ended::How::not_started) {
        return bad_end(Verdict::memory, "needs more memory than there is before it starts", 0);
    }
    if (e.how == Ended::How::out_of_time) {
        return bad_end(Verdict::timeout, "took too long", e.seconds);
    }
    if (e.how == Ended::How::output_limit) {
        return bad_end(Verdict::output_limit, "printed too much", e.seconds);
    }
    if (e.how == Ended::How::signalled) {
        switch (e.code) {
            case SIGSYS:
                return bad_end(Verdict::forbidden, "asked the system for what it may not",
                               e.seconds);
            case SIGPROF:
            case SIGXCPU:
                return bad_end(Verdict::timeout, "took too long", e.seconds);
            default:
                return has(e.diagnostics, {"bad_alloc"})
                           ? bad_end(Verdict::memory, "ran out of memory", e.seconds)
                           : bad_end(Verdict::crash, "ended by " + signal_words(e.code), e.seconds);
        }
    }
    if (e.code != 0 || e.output.size() != expected) {
        return bad_end(Verdict::protocol, "ended without having answered all questions", e.seconds);
    }
    return {Verdict::ok, {}, "", e.seconds};
}

void put(std::string& to, const void* from, std::size_t size) {
    to.append(static_cast<const char*>(from), size);
}

// The rows in an order that follows from the questions, then every eighth of them once more.
std::vector<std::size_t> order_of(const Batch& batch, int order) {
    std::vector<std::size_t> rows(batch.rows());
    std::iota(rows.begin(), rows.end(), 0);
    auto seed = static_cast<std::uint32_t>(order);
    for (const double x : batch.questions) {
        seed = seed * 16777619U ^ static_cast<std::uint32_t>(std::hash<double>()(x));
    }
    std::shuffle(rows.begin(), rows.end(), std::mt19937(seed));
    for (std::size_t i = 0, end = (rows.size() + 7) / 8; i < end; ++i) {
        rows.push_back(rows[i]);
    }
    return rows;
}

// Lanes have other neighbours the second time.
const char* inconstant(const Batch& batch) {
    return batch.number == "lanes" ? "the answer in a lane depends on what is in the others"
                                   : "answers the same question differently the second time";
}

bool same(double a, double b) {
    return a == b || (a != a && b != b);
}

}  // namespace

Workshop::Workshop(const Lesson& lesson, const std::string& text, const fs::path& root)
    : lesson_{lesson.name, lesson.header, {}}, folder_(home_.path()) {
    const fs::path include = folder_ / "include";
    copy_headers(root, "framework", include);
    copy_headers(root, "tests/grading/runner", include);
    copy_headers(root, "tests/grading/questions", include);
    for (const auto& entry : fs::directory_iterator(root / "lessons")) {
        if (entry.is_directory() && entry.path().filename() <= lesson.name) {
            copy_headers(root, fs::relative(entry.path(), root), include);
        }
    }
    const fs::path own = fs::path("lessons") / lesson.name / lesson.header;
    fs::remove(include / own);
    fs::create_directories((folder_ / "student" / own).parent_path());
    write_text(folder_ / "student" / own, text);
    write_text(folder_ / "student/answers.cpp", answers_source(lesson));
    fs::copy_file(GLINT_RUNNER, folder_ / "runner.o");
    fs::create_directory(folder_ / "work");
    if (const auto user = nobodys_user()) {
        if (chown((folder_ / "work").c_str(), *user, *user) != 0) {
            throw std::runtime_error("the work folder cannot be given away");
        }
    }
}

Compiled Workshop::compile() {
    const Ended e = run_confined(
        compiler({"-S", "-std=c++20", "-O1", GLINT_ARCHITECTURE, "-ffp-contract=off",
                  "-ftrivial-auto-var-init=pattern", "-pipe", "-fmax-errors=5",
                  "-ftemplate-depth=256", "-fconstexpr-ops-limit=10000000",
                  "-fno-diagnostics-show-caret", "-fdiagnostics-color=never", "-I../student",
                  "-I../include", "../student/answers.cpp", "-o", "answers.s"}),
        compiling(folder_));
    if (e.how != Ended::How::exited || e.code != 0) {
        return failed_compilation(e, Verdict::compile_error);
    }
    // The compiler marks what came from asm("...").
    if (read_text(folder_ / "work/answers.s").find("#APP") != std::string::npos) {
        return {Verdict::rejected, "inline assembly"};
    }
    return assemble();
}

Compiled Workshop::assemble() {
    const Ended e = run_confined(compiler({"-static", "answers.s", "../runner.o", "-o", "program"}),
                                 compiling(folder_));
    return e.how == Ended::How::exited && e.code == 0 ? Compiled{Verdict::ok, ""}
                                                      : failed_compilation(e, Verdict::link_error);
}

Answered Workshop::ask(int task, const Batch& batch) {
    Answered first = ask_once(task, batch, 1);
    if (first.verdict != Verdict::ok) {
        return first;
    }
    Answered second = ask_once(task, batch, 2);
    if (second.verdict != Verdict::ok) {
        return second;
    }
    if (!std::equal(first.answers.begin(), first.answers.end(), second.answers.begin(), same)) {
        return bad_end(Verdict::wrong, inconstant(batch), first.seconds);
    }
    first.seconds = std::max(first.seconds, second.seconds);
    return first;
}

Answered Workshop::ask_once(int task, const Batch& batch, int order) {
    const std::vector<std::size_t> rows = order_of(batch, order);
    const std::size_t width = batch.answers_a_row;
    const Request request{.tag = std::random_device()() * 0x100000001ULL,
                          .task = static_cast<std::uint32_t>(task),
                          .number = number_of(batch),
                          .rows = static_cast<std::uint32_t>(rows.size()),
                          .columns = static_cast<std::uint32_t>(batch.columns),
                          .answers_a_row = static_cast<std::uint32_t>(width)};
    std::string input;
    put(input, &request, sizeof request);
    for (const std::size_t row : rows) {
        put(input, &batch.questions[row * batch.columns], batch.columns * sizeof(double));
    }
    const Ended e = run_confined({folder_ / "work/program", {}, {}, input},
                                 {Calls::running, run_limits, std::nullopt, nobodys_user(), "/"});
    const std::size_t numbers = rows.size() * width;
    Answered a = judge_end(e, sizeof(Reply) + numbers * sizeof(double));
    if (a.verdict != Verdict::ok) {
        return a;
    }
    Reply reply{};
    std::memcpy(&reply, e.output.data(), sizeof reply);
    if (reply.tag != reply_tag(request.tag) || reply.rows != rows.size()) {
        return bad_end(Verdict::protocol, "answers that nobody asked for", e.seconds);
    }
    std::vector<double> answers(numbers);
    std::memcpy(answers.data(), e.output.data() + sizeof reply, numbers * sizeof(double));
    a.answers.resize(batch.rows() * width);
    for (std::size_t i = 0; i < numbers; ++i) {
        double& place = a.answers[rows[i / width] * width + i % width];
        if (i / width >= batch.rows() && !same(place, answers[i])) {
            return bad_end(Verdict::wrong, inconstant(batch), e.seconds);
        }
        place = answers[i];
    }
    return a;
}

}  // namespace glint::grading
