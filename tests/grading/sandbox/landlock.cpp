#include "tests/grading/sandbox/landlock.hpp"

#include <array>
#include <cstdint>
#include <fcntl.h>
#include <linux/landlock.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <unistd.h>

namespace glint::grading {
namespace {

// linux/landlock.h of today; older ones lack the later fields.
struct Ruleset {
    std::uint64_t files, network, scope;
};

// All rights over files that each version knows, and the size of its rule set.
struct Version {
    std::uint64_t files;
    std::size_t size;
};
constexpr std::array<Version, 6> versions{
    {{0x1fff, 8}, {0x3fff, 8}, {0x7fff, 8}, {0x7fff, 16}, {0xffff, 16}, {0xffff, 24}}};

constexpr std::uint64_t reading =
    LANDLOCK_ACCESS_FS_EXECUTE | LANDLOCK_ACCESS_FS_READ_FILE | LANDLOCK_ACCESS_FS_READ_DIR;
constexpr std::uint64_t no_devices_nor_links = ~std::uint64_t{
    LANDLOCK_ACCESS_FS_MAKE_CHAR | LANDLOCK_ACCESS_FS_MAKE_BLOCK | LANDLOCK_ACCESS_FS_MAKE_SOCK |
    LANDLOCK_ACCESS_FS_MAKE_FIFO | LANDLOCK_ACCESS_FS_MAKE_SYM};
// What can be said of a file that is no folder.
constexpr std::uint64_t of_a_file = LANDLOCK_ACCESS_FS_EXECUTE | LANDLOCK_ACCESS_FS_WRITE_FILE |
                                    LANDLOCK_ACCESS_FS_READ_FILE | std::uint64_t{1} << 14 |
                                    std::uint64_t{1} << 15;

bool allow(long rules, const std::filesystem::path& path, std::uint64_t rights) {
    const int file = open(path.c_str(), O_PATH | O_CLOEXEC);
    struct stat info {};
    if (file < 0 || fstat(file, &info) != 0) {
        return true;
    }
    landlock_path_beneath_attr beneath{};
    beneath.allowed_access = S_ISDIR(info.st_mode) ? rights : rights & of_a_file;
    beneath.parent_fd = file;
    const long added =
        syscall(SYS_landlock_add_rule, rules, LANDLOCK_RULE_PATH_BENEATH, &beneath, 0);
    close(file);
    return added == 0;
}

}  // namespace

int landlock_version() {
    const long version =
        syscall(SYS_landlock_create_ruleset, nullptr, 0, LANDLOCK_CREATE_RULESET_VERSION);
    return version > 0 ? static_cast<int>(version) : 0;
}

bool keep_within(const Reach& reach) {
    const int version = landlock_version();
    if (version == 0) {
        return true;
    }
    const Version& known =
        versions[std::min<std::size_t>(static_cast<std::size_t>(version), versions.size()) - 1];
    const Ruleset all{known.files, 3, 3};
    const long rules = syscall(SYS_landlock_create_ruleset, &all, known.size, 0);
    if (rules < 0) {
        return false;
    }
    bool worked = true;
    for (const auto& path : reach.readable) {
        worked = worked && allow(rules, path, reading & known.files);
    }
    for (const auto& path : reach.writable) {
        worked = worked && allow(rules, path, no_devices_nor_links & known.files);
    }
    worked = worked && syscall(SYS_landlock_restrict_self, rules, 0) == 0;
    close(static_cast<int>(rules));
    return worked;
}

}  // namespace glint::grading
