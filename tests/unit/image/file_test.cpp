#include "framework/image/file.hpp"

#include "framework/math/error.hpp"
#include "tests/temporary.hpp"
#include "tests/unit/image/bytes.hpp"

#include <doctest/doctest.h>

#include <csignal>
#include <sys/resource.h>
#include <unistd.h>

namespace glint {
namespace {

namespace fs = std::filesystem;
using doctest::Contains;

// The rights of a user who is not root, for whom every door is open.
class NoPrivilege {
  public:
    NoPrivilege() { gone_ = ::geteuid() != 0 || ::seteuid(65534) == 0; }
    ~NoPrivilege() {
        if (::getuid() == 0) {
            (void)!::seteuid(0);
        }
    }
    NoPrivilege(const NoPrivilege&) = delete;
    NoPrivilege& operator=(const NoPrivilege&) = delete;
    bool gone() const { return gone_; }

  private:
    bool gone_ = false;
};

TEST_CASE("what is written is read again, whatever its length") {
    const TemporaryFolder folder;
    const std::size_t block = std::size_t{1} << 20;
    for (const std::size_t size : {std::size_t{0}, std::size_t{1}, block, block + 1, 3 * block}) {
        Bytes bytes(size);
        for (std::size_t i = 0; i < size; ++i) {
            bytes[i] = static_cast<std::byte>(i * 2654435761U >> 13);
        }
        write_file(folder / "a", bytes);
        CHECK(read_file(folder / "a") == bytes);
    }
    CHECK(folder.count() == 1);
}

TEST_CASE("a link stays a link, and what it names is written") {
    const TemporaryFolder folder;
    write_file(folder / "a", bytes_of("old"));
    fs::create_symlink(folder / "a", folder / "link");
    write_file(folder / "link", bytes_of("new"));
    CHECK(fs::is_symlink(folder / "link"));
    CHECK(read_file(folder / "a") == bytes_of("new"));
}

TEST_CASE("devices are written to, not replaced") {
    write_file("/dev/null", bytes_of("gone"));
    CHECK(fs::is_character_file("/dev/null"));
    CHECK_THROWS_WITH_AS(write_file("/dev/full", bytes_of("much")),
                         "cannot write '/dev/full': No space left on device", Error);
}

TEST_CASE("errors name the path and the reason") {
    const TemporaryFolder folder;
    CHECK_THROWS_WITH_AS(read_file("no/such.png"),
                         "cannot read 'no/such.png': No such file or directory", Error);
    CHECK_THROWS_WITH_AS(read_file(folder / ""), Contains("Is a directory"), Error);
    CHECK_THROWS_WITH_AS(write_file("no/such/folder.png", {}),
                         "cannot write 'no/such/folder.png': No such file or directory", Error);
    CHECK_THROWS_WITH_AS(write_file(folder / "", {}), Contains("Is a directory"), Error);
    CHECK(folder.count() == 0);
}

TEST_CASE("permissions are kept") {
    const TemporaryFolder folder;
    write_file(folder / "secret", bytes_of("a"));
    fs::permissions(folder / "secret", fs::perms::none);
    fs::create_directory(folder / "open");
    write_file(folder / "open/fixed", bytes_of("a"));
    fs::permissions(folder / "open/fixed", fs::perms(0444));
    fs::permissions(folder / "open", fs::perms(0777));
    fs::permissions(folder / "", fs::perms(0555));
    {
        const NoPrivilege user;
        if (!user.gone()) {
            MESSAGE("not tested: this root cannot become another user");
            return;
        }
        CHECK_THROWS_WITH_AS(read_file(folder / "secret"), Contains("Permission denied"), Error);
        CHECK_THROWS_WITH_AS(write_file(folder / "new", {}), Contains("Permission denied"), Error);
        CHECK_THROWS_WITH_AS(write_file(folder / "open/fixed", {}), Contains("Permission denied"),
                             Error);
    }
    fs::permissions(folder / "", fs::perms(0755));
    CHECK(read_file(folder / "open/fixed") == bytes_of("a"));
    CHECK(folder.count() == 2);
}

// No file may grow beyond some bytes: a disk that is full.
class FullDisk {
  public:
    explicit FullDisk(rlim_t size) : handler_(std::signal(SIGXFSZ, SIG_IGN)) {
        ::getrlimit(RLIMIT_FSIZE, &before_);
        const rlimit limit{size, before_.rlim_max};
        ::setrlimit(RLIMIT_FSIZE, &limit);
    }
    ~FullDisk() {
        ::setrlimit(RLIMIT_FSIZE, &before_);
        (void)std::signal(SIGXFSZ, handler_);
    }
    FullDisk(const FullDisk&) = delete;
    FullDisk& operator=(const FullDisk&) = delete;

  private:
    rlimit before_{};
    void (*handler_)(int);
};

TEST_CASE("a write that fails half way leaves the old file and nothing else") {
    const TemporaryFolder folder;
    write_file(folder / "a", bytes_of("old"));
    for (const std::size_t size : {std::size_t{1001}, std::size_t{1} << 20}) {
        const FullDisk disk(1000);
        CHECK_THROWS_WITH_AS(write_file(folder / "a", Bytes(size)), Contains("File too large"),
                             Error);
    }
    CHECK_THROWS_WITH_AS(write_file(folder / std::string(300, 'x'), {}),
                         Contains("File name too long"), Error);
    CHECK(read_file(folder / "a") == bytes_of("old"));
    CHECK(folder.count() == 1);
}

}  // namespace
}  // namespace glint
