// Grades a class on many machines, by Slurm.
#pragma once

#include "tests/grading/class.hpp"

namespace glint::grading {

struct Array {
    std::vector<std::string> command;  // grades the part that "I/N" after it names
    std::filesystem::path folder;      // of the script and the logs
    int chunk;                         // students a task
    int processors;                    // for each task
};

// Submits an array job, one task for each chunk of so many students, and waits until Slurm has
// none of it any more. Where an array of that folder is still there, waits for that one instead:
// so who was stopped calls again. Slurm's controller may go and come back meanwhile. An Error
// where it does not answer to begin with, or where the job cannot be submitted.
void run_array(const Array& array, std::size_t students);

}  // namespace glint::grading
