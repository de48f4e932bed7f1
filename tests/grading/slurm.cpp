#include "tests/grading/slurm.hpp"

#include "framework/image/file.hpp"
#include "framework/math/error.hpp"
#include "tests/grading/digest.hpp"
#include "tests/grading/plain_text.hpp"

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <iostream>
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

// What Slurm complains of, on one line.
std::string complaint(const Output& o) {
    std::string words = printable(o.text, 400);
    words.erase(words.find_last_not_of('\n') + 1);
    std::replace(words.begin(), words.end(), '\n', ' ');
    return words;
}

// The same for the same folder, so that its job is found again.
std::string name_of(const Array& a) {
    return "grade_" + sha256(a.folder.string()).substr(0, 12);
}

// A line for each task that waits or runs.
Output queue_of(const Array& a) {
    return output_of("squeue --noheader --array --format=%i --name=" + name_of(a));
}

std::size_t tasks_in(const Output& queue) {
    return static_cast<std::size_t>(std::count(queue.text.begin(), queue.text.end(), '\n'));
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
        throw Error("the class was not handed to Slurm: " + complaint(said));
    }
    std::clog << said.text << "Logs and the script are in " << a.folder.string() << '\n';
}

}  // namespace

void run_array(const Array& a, std::size_t students) {
    const auto chunk = static_cast<std::size_t>(a.chunk);
    const std::size_t tasks = std::max<std::size_t>(1, (students + chunk - 1) / chunk);
    Output queue = queue_of(a);
    if (!queue.good) {  // a controller that never answered may never come
        throw Error("--slurm: squeue does not answer; start Slurm, or leave it out: " +
                    complaint(queue));
    }
    if (tasks_in(queue) == 0) {
        submit(a, tasks);
        queue = queue_of(a);
    }
    for (; !queue.good || tasks_in(queue) > 0; queue = queue_of(a)) {
        std::clog << (queue.good ? '\r' + std::to_string(tasks_in(queue)) + " of " +
                                       std::to_string(tasks) + " tasks wait or run    "
                                 : std::string("\rSlurm does not answer; waiting"))
                  << std::flush;
        std::this_thread::sleep_for(2s);
    }
    std::clog << '\n';
}

}  // namespace glint::grading
