#include "tests/grading/archive.hpp"

#include "framework/math/error.hpp"
#include "tests/grading/plain_text.hpp"
#include "tests/grading/sandbox/confine.hpp"
#include "tests/temporary.hpp"

#include <sstream>
#include <strings.h>
#include <unistd.h>

namespace glint::grading {
namespace {

namespace fs = std::filesystem;
using namespace std::chrono_literals;

constexpr const char* unzip_program = "/usr/bin/unzip";
constexpr int none_matches = 11;  // what unzip then exits with
constexpr std::uintmax_t largest_archive = 64 * MB;

Ended unzip(const fs::path& folder, std::vector<std::string> arguments) {
    return run_confined({unzip_program, std::move(arguments), {"LC_ALL=C.UTF-8"}, ""},
                        {Calls::compiling,
                         {5s, 10s, 256 * MB, 8 * MB, 0, 0, largest_submission},
                         Reach{{"/usr", "/lib", "/lib64", folder}, {}},
                         nobodys_user(),
                         folder});
}

bool is_pattern(const std::string& member) {
    return member.find_first_of("*?[]\\") != std::string::npos || member.starts_with("-");
}

}  // namespace

bool is_archive(const fs::path& file) {
    return strcasecmp(file.extension().c_str(), ".zip") == 0;
}

bool can_unzip() {
    return access(unzip_program, X_OK) == 0;
}

Intake take_from_archive(const fs::path& archive, const std::string& name) {
    if (!can_unzip()) {
        throw Error(archive.string() + ": zip archives are read by " + unzip_program +
                    ", which is missing; on Debian, install it by: apt-get install unzip");
    }
    if (fs::symlink_status(archive).type() != fs::file_type::regular ||
        fs::file_size(archive) > largest_archive) {
        return refuse("no archive, or larger than 64 MB");
    }
    const TemporaryFolder folder;
    std::error_code error;
    if (!fs::copy_file(archive, folder.path() / "a.zip", error)) {
        return cannot_read(error.message());
    }
    fs::permissions(folder.path() / "a.zip", fs::perms(0444));
    // Of those alone that may be it, for there may be thousands of others.
    const Ended list = unzip(folder.path(), {"-Z1", "a.zip", '*' + name});
    if (list.how == Ended::How::exited && list.code == none_matches) {
        return refuse("");
    }
    if (list.how != Ended::How::exited || list.code != 0) {
        return refuse("an archive that cannot be read");
    }
    std::string member;
    std::istringstream names(list.diagnostics);
    for (std::string line; std::getline(names, line);) {
        if (line == name || line.ends_with('/' + name)) {
            if (!member.empty() || is_pattern(line)) {
                return refuse("more than one in the archive, or of an odd name");
            }
            member = line;
        }
    }
    if (member.empty()) {
        return refuse("");
    }
    const Ended e = unzip(folder.path(), {"-p", "-qq", "a.zip", member});
    return e.how == Ended::How::output_limit            ? refuse("larger than 256 kB")
           : e.how != Ended::How::exited || e.code != 0 ? refuse("cannot be unpacked")
           : !is_plain_text(e.diagnostics)              ? refuse("not a text in UTF-8")
                                                        : Intake{e.diagnostics, ""};
}

}  // namespace glint::grading
