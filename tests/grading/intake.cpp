#include "tests/grading/intake.hpp"

#include "tests/grading/plain_text.hpp"

#include <cerrno>
#include <cstring>
#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

namespace glint::grading {
namespace {

// Never waits, as opening a FIFO would.
constexpr int carefully = O_RDONLY | O_NOFOLLOW | O_NONBLOCK | O_NOCTTY | O_CLOEXEC;

Intake not_opened(int reason) {
    switch (reason) {
        case ENOENT:
        case ENOTDIR:
            return refuse("");
        case ELOOP:
            return refuse("a link");
        case ENXIO:
            return refuse("not a regular file");  // a socket
        default:
            return cannot_read(std::strerror(reason));
    }
}

Intake read_file(int file) {
    struct stat info {};
    if (fstat(file, &info) != 0) {
        return cannot_read(std::strerror(errno));
    }
    if (!S_ISREG(info.st_mode)) {
        return refuse("not a regular file");
    }
    if (info.st_nlink != 1) {
        return refuse("a file with a second name");
    }
    if (static_cast<std::size_t>(info.st_size) > largest_submission) {
        return refuse("larger than 256 kB");
    }
    std::string text(largest_submission + 1, '\0');
    std::size_t size = 0;
    for (ssize_t got = 1; got > 0 && size < text.size(); size += static_cast<std::size_t>(got)) {
        got = read(file, text.data() + size, text.size() - size);
        if (got < 0) {
            return cannot_read(std::strerror(errno));
        }
    }
    text.resize(size);
    return size > largest_submission ? refuse("larger than 256 kB")
           : !is_plain_text(text)    ? refuse("not a text in UTF-8")
                                     : Intake{text, ""};
}

}  // namespace

Intake take_in(const std::filesystem::path& folder, const std::filesystem::path& below) {
    int at = open(folder.c_str(), carefully);
    for (const auto& part : below) {
        if (at < 0) {
            break;
        }
        const int next = openat(at, part.c_str(), carefully);
        const int why = errno;
        close(at);
        at = next;
        errno = why;
    }
    if (at < 0) {
        return not_opened(errno);
    }
    Intake taken = read_file(at);
    close(at);
    return taken;
}

}  // namespace glint::grading
