#include "tests/grading/slurm.hpp"

#include "framework/image/file.hpp"
#include "framework/math/error.hpp"
#include "tests/grading/digest.hpp"
#include "tests/grading/plain_text.hpp"

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <iostream>
#include <optional>
#include <thread>

namespace glint::grading {
namespace {

using namespace std::chrono_literals;

// Room for the compiler's limit and the grader.
constexpr const char* memory_a_processor = "2500M";

struct Output {
    std::string text;
    bool good;
};

Output output_of(const std::string& command) {
    FILE* pipe = popen((command + " 2>&1").c_str(), "r");
    if (pipe == nullptr) {
        throw Error("no more processes can be started");
    }
    std::string text;
    for (int c = std::fgetc(pipe); c != EOF; c = std::fgetc(pipe)) {
        text += static_cast<char>(c);
    }
    return {text, pclose(pipe) == 0};
}

// The same for the same folder, so that its job is found again.
std::string name_of(const Array& a) {
    return "grade_" + sha256(a.folder.string()).substr(0, 12);
}

// Tasks that wait or run; none where the controller does not answer.
std::optional<std::size_t> tasks_left(const Array& a) {
    const Output queue = output_of("squeue --noheader --array --format=%i --name=" + name_of(a));
    return queue.good ? std::optional(std::count(queue.text.begin(), queue.text.end(), '\n'))
                      : std::nullopt;
}

std::string script_of(const Array& a, std::size_t tasks) {
    std::string script = "#!/bin/bash\n# One task of an array: grades every " +
                         std::to_string(tasks) + "th student.\nexec";
    for (const std::string& word : a.command) {
        script += ' ' + shell_word(word);
    }
    return script + " \"$SLURM_ARRAY_TASK_ID/" + std::to_string(tasks) + "\"\n";
}

void submit(const Array& a, std::size_t tasks) {
    std::filesystem::create_directories(a.folder);
    write_text(a.folder / "array.sh", script_of(a, tasks));
    const Output said =
        output_of("sbatch --requeue --open-mode=append --output=%a.log --job-name=" + name_of(a) +
                  " --array=0-" + std::to_string(tasks - 1) + " --cpus-per-task=" +
                  std::to_string(a.processors) + " --mem-per-cpu=" + memory_a_processor +
                  " --chdir=" + shell_word(a.folder.string()) + ' ' +
                  shell_word((a.folder / "array.sh").string()));
    if (!said.good) {
        throw Error("the class was not handed to Slurm: " + printable(said.text, 400));
    }
    std::clog << said.text << "Logs and the script are in " << a.folder.string() << '\n';
}

}  // namespace

void run_array(const Array& a, std::size_t students) {
    const auto chunk = static_cast<std::size_t>(a.chunk);
    const std::size_t tasks = std::max<std::size_t>(1, (students + chunk - 1) / chunk);
    std::optional<std::size_t> left = tasks_left(a);
    if (left == std::optional<std::size_t>(0)) {
        submit(a, tasks);
        left = tasks;
    }
    for (; left != std::optional<std::size_t>(0); left = tasks_left(a)) {
        std::clog << (left ? '\r' + std::to_string(*left) + " of " + std::to_string(tasks) +
                                 " tasks wait or run    "
                           : std::string("\rSlurm does not answer; waiting"))
                  << std::flush;
        std::this_thread::sleep_for(2s);
    }
    std::clog << '\n';
}

}  // namespace glint::grading
