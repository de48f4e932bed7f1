// Which files a confined process may reach: Linux's Landlock.
#pragma once

#include <filesystem>
#include <vector>

namespace glint::grading {

struct Reach {
    std::vector<std::filesystem::path> readable;  // files and folders, programs to be started too
    std::vector<std::filesystem::path> writable;
};

// The kernel's version of Landlock; 0 where it has none.
int landlock_version();

// For the calling process, for good: no file but these, no network, no signal to others, as far as
// the kernel's version knows how. Paths that are not there are left out. False where it fails,
// which no version is not.
bool keep_within(const Reach& reach);

}  // namespace glint::grading
