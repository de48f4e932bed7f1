#include "framework/image/file.hpp"

#include "framework/math/error.hpp"

#include <cerrno>
#include <cstdio>
#include <fcntl.h>
#include <memory>
#include <string>
#include <system_error>
#include <unistd.h>

namespace glint {
namespace fs = std::filesystem;
namespace {

struct Close {
    void operator()(std::FILE* file) const { (void)std::fclose(file); }
};
using File = std::unique_ptr<std::FILE, Close>;

[[noreturn]] void fail(const char* deed, const fs::path& path, int reason) {
    throw Error(std::string("cannot ") + deed + " '" + path.string() +
                "': " + std::generic_category().message(reason));
}

// 0, or the errno of what went wrong.
int write_bytes(const fs::path& path, std::span<const std::byte> bytes) {
    File file(std::fopen(path.c_str(), "wb"));
    if (!file) {
        return errno;
    }
    if (std::fwrite(bytes.data(), 1, bytes.size(), file.get()) != bytes.size()) {
        return errno;
    }
    return std::fclose(file.release()) == 0 ? 0 : errno;  // a full disk may show only here
}

int replace_file(const fs::path& path, std::span<const std::byte> bytes) {
    const fs::path part = path.string() + ".part" + std::to_string(::getpid());
    int reason = write_bytes(part, bytes);
    if (reason == 0 && std::rename(part.c_str(), path.c_str()) != 0) {
        reason = errno;
    }
    if (reason != 0) {
        (void)std::remove(part.c_str());
    }
    return reason;
}

}  // namespace

void require_file_size(const fs::path& path, long long width, long long height) {
    if (width < 1 || height < 1 || width > max_file_side || height > max_file_side) {
        const std::string limit = std::to_string(max_file_side);
        throw Error("'" + path.string() + "': a picture file holds 1x1 to " + limit + "x" + limit +
                    " pixels, not " + std::to_string(width) + "x" + std::to_string(height));
    }
}

std::vector<std::byte> read_file(const fs::path& path) {
    const File file(std::fopen(path.c_str(), "rb"));
    if (!file) {
        fail("read", path, errno);
    }
    std::vector<std::byte> bytes;
    constexpr std::size_t block = std::size_t{1} << 20;  // a pipe does not tell its length
    for (std::size_t got = block; got == block;) {
        const std::size_t size = bytes.size();
        bytes.resize(size + block);
        got = std::fread(bytes.data() + size, 1, block, file.get());
        bytes.resize(size + got);
    }
    if (std::ferror(file.get()) != 0) {
        fail("read", path, errno);
    }
    return bytes;
}

void write_file(const fs::path& path, std::span<const std::byte> bytes) {
    std::error_code ignored;
    int reason = 0;
    if (!fs::exists(path, ignored)) {
        reason = replace_file(path, bytes);
    } else if (!fs::is_regular_file(path, ignored)) {
        reason = write_bytes(path, bytes);
    } else if (::faccessat(AT_FDCWD, path.c_str(), W_OK, AT_EACCESS) != 0) {
        reason = errno;
    } else {
        reason = replace_file(fs::canonical(path, ignored), bytes);  // a link stays a link
    }
    if (reason != 0) {
        fail("write", path, reason);
    }
}

std::string read_text(const fs::path& path) {
    const std::vector<std::byte> bytes = read_file(path);
    return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

void write_text(const fs::path& path, std::string_view text) {
    write_file(path, std::as_bytes(std::span(text)));
}

}  // namespace glint
