// MERL files, as bytes and as the lesson's program takes them.
#include "framework/app/merl.hpp"

#include "framework/image/png.hpp"
#include "framework/math/error.hpp"
#include "tests/unit/app/program.hpp"
#include "tests/worst.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <limits>
#include <random>
#include <span>

namespace glint {
namespace {

using doctest::Contains;

// Red, then green, then blue, no two alike.
MerlBrdf numbered(int half, int difference, int azimuth) {
    MerlBrdf m{half, difference, azimuth, {}};
    for (int i = 0; i < half * difference * azimuth; ++i) {
        m.values.emplace_back(i + 0.25, i + 1000.5, i + 1e6);
    }
    return m;
}

std::vector<std::byte> file_of(const std::vector<std::int32_t>& counts,
                               const std::vector<double>& values) {
    const auto head = std::as_bytes(std::span(counts));
    const auto body = std::as_bytes(std::span(values));
    std::vector<std::byte> bytes(head.begin(), head.end());
    bytes.insert(bytes.end(), body.begin(), body.end());
    return bytes;
}

MerlBrdf read(const std::vector<std::byte>& bytes) {
    const TemporaryFolder folder;
    write_file(folder / "a.binary", bytes);
    return read_merl(folder / "a.binary");
}

TEST_CASE("a file is three counts, then planes of red, green and blue with scales of their own") {
    const MerlBrdf m = read(file_of({1, 2, 1}, {1500, 3000, 1500, 0, 1500, -1500}));
    CHECK(m.half == 1);
    CHECK(m.difference == 2);
    CHECK(m.azimuth == 1);
    REQUIRE(m.values.size() == 2);
    CHECK(length(m.values[0] - Rgb<double>(1, 1.15, 1.66)) < 1e-15);
    CHECK(length(m.values[1] - Rgb<double>(2, 0, -1.66)) < 1e-15);  // negative: not measured
}

TEST_CASE("what is written is read again") {
    const TemporaryFolder folder;
    for (const MerlBrdf& m : {numbered(1, 1, 1), numbered(3, 4, 6), numbered(90, 90, 180)}) {
        write_merl(folder / "a.binary", m);
        CHECK(std::filesystem::file_size(folder / "a.binary") == 12 + 24 * m.values.size());
        const MerlBrdf again = read_merl(folder / "a.binary");
        CHECK(again.half == m.half);
        CHECK(again.difference == m.difference);
        CHECK(again.azimuth == m.azimuth);
        REQUIRE(again.values.size() == m.values.size());
        double worst = 0;
        for (std::size_t i = 0; i < m.values.size(); ++i) {
            worst = worse(worst, length(again.values[i] / m.values[i] - 1.0));
        }
        CHECK(worst < 1e-15);
    }
    CHECK(folder.count() == 1);
}

TEST_CASE("a bad file is an error that says what is bad") {
    const std::vector<double> six(6, 1.0);
    CHECK_THROWS_WITH_AS(read({}), Contains("too short for a header"), Error);
    CHECK_THROWS_WITH_AS(read(file_of({1, 1}, {})), Contains("too short for a header"), Error);
    for (const std::int32_t count : {0, -1, 513, std::numeric_limits<std::int32_t>::max(),
                                     std::numeric_limits<std::int32_t>::min()}) {
        CHECK_THROWS_WITH_AS(read(file_of({1, count, 1}, six)), Contains("not 1 to 512 each"),
                             Error);
    }
    CHECK_THROWS_WITH_AS(read(file_of({1, 1, 1}, six)),
                         Contains("1 x 1 x 1 angles in 36 bytes, it holds 60"), Error);
    CHECK_THROWS_WITH_AS(read(file_of({90, 90, 180}, six)),
                         Contains("in 34992012 bytes, it holds 60"), Error);
    CHECK_THROWS_WITH_AS(read(file_of({512, 512, 512}, six)),
                         Contains("in 3221225484 bytes, it holds 60"), Error);
    for (const double odd :
         {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
        CHECK_THROWS_WITH_AS(read(file_of({1, 1, 2}, {1, 1, 1, 1, 1, odd})),
                             Contains("a value that is not finite"), Error);
    }
    const TemporaryFolder folder;
    CHECK_THROWS_WITH_AS(read_merl(folder / "none.binary"), Contains("No such file"), Error);
    CHECK_THROWS_AS(write_merl(folder / "no/folder.binary", numbered(1, 1, 1)), Error);
}

TEST_CASE("a file cut short or spoiled is read or refused, never more") {
    const MerlBrdf m = numbered(2, 2, 2);
    const TemporaryFolder folder;
    write_merl(folder / "a.binary", m);
    const std::vector<std::byte> whole = read_file(folder / "a.binary");
    for (std::size_t size = 0; size < whole.size(); ++size) {
        CHECK_THROWS_AS(read({whole.begin(), whole.begin() + static_cast<std::ptrdiff_t>(size)}),
                        Error);
    }
    std::mt19937 random(7);
    int refused = 0;
    for (int i = 0; i < 500; ++i) {
        std::vector<std::byte> spoiled = whole;
        for (int k = 0; k < 1 + i % 4; ++k) {
            spoiled[random() % (i % 2 == 0 ? 12 : whole.size())] = static_cast<std::byte>(random());
        }
        try {
            const MerlBrdf found = read(spoiled);
            CHECK(found.values.size() ==
                  static_cast<std::size_t>(found.half * found.difference * found.azimuth));
            for (const Rgb<double>& value : found.values) {
                CHECK(std::isfinite(value.r + value.g + value.b));
            }
        } catch (const Error&) {
            ++refused;
        }
    }
    CHECK(refused > 200);
}

Run run(const TemporaryFolder& folder, const std::string& arguments) {
    return run(MEASURED_PROGRAM, folder, arguments + " --size 120x60");
}

TEST_CASE("the program writes a table, and shades from it as from the formula") {
    const TemporaryFolder folder;
    const Run written = run(folder, "--set size=24 --write a.binary --out formula.png");
    CHECK(written.status == 0);
    CHECK(written.err.empty());
    const MerlBrdf m = read_merl(folder / "a.binary");
    CHECK(m.half == 24);
    CHECK(m.difference == 24);
    CHECK(m.azimuth == 48);
    const Run shaded = run(folder, "--read a.binary --set size=0 --out file.png");
    CHECK(shaded.status == 0);
    CHECK(shaded.err.empty());
    const SrgbImage a = read_png(folder / "formula.png");
    const SrgbImage b = read_png(folder / "file.png");
    int differing = 0;  // upper knot: the same table, from memory and from the file
    for (int y = 0; y < 30; ++y) {
        for (int x = 0; x < 120; ++x) {
            differing += std::abs(a(x, y).g - b(x, y).g) > 1 ? 1 : 0;
        }
    }
    CHECK(differing == 0);
}

TEST_CASE("the program takes no bad table: exit code 2, one line, no picture") {
    const TemporaryFolder folder;
    write_file(folder / "short.binary", file_of({90, 90, 180}, {1.0}));
    write_merl(folder / "odd.binary", numbered(2, 2, 3));
    for (const std::string arguments :
         {"--read none.binary", "--read short.binary", "--read odd.binary",
          "--set size=4 --write no/such/folder.binary", "--set size=4 --write table.png"}) {
        CAPTURE(arguments);
        const Run r = run(folder, arguments + " --out a.png");
        CHECK(r.status == 2);
        CHECK(r.err.starts_with("error: "));
        CHECK(lines(r.err) == 1);
        CHECK(r.out.empty());
    }
    CHECK(folder.count() == 2);
    CHECK(run(folder, "--help").out.find("--read FILE.binary") != std::string::npos);
}

}  // namespace
}  // namespace glint
