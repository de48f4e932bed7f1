#include "framework/image/png.hpp"

#include "framework/image/file.hpp"
#include "framework/math/error.hpp"
#include "tests/temporary.hpp"
#include "tests/unit/image/bytes.hpp"

#include <doctest/doctest.h>

#include <algorithm>

namespace glint {
namespace {

using doctest::Contains;

std::uint32_t crc32(const Bytes& bytes) {
    std::uint32_t crc = ~0U;
    for (const std::byte byte : bytes) {
        crc ^= static_cast<std::uint32_t>(byte);
        for (int bit = 0; bit < 8; ++bit) {
            crc = (crc >> 1) ^ ((crc & 1U) != 0 ? 0xEDB88320U : 0U);
        }
    }
    return ~crc;
}

std::uint32_t adler32(const Bytes& bytes) {
    std::uint32_t a = 1;
    std::uint32_t b = 0;
    for (const std::byte byte : bytes) {
        a = (a + static_cast<std::uint32_t>(byte)) % 65521;
        b = (b + a) % 65521;
    }
    return b << 16 | a;
}

Bytes chunk(const std::string& name, const Bytes& data) {
    const Bytes body = bytes_of(name) + data;
    return big_endian(static_cast<std::uint32_t>(data.size())) + body + big_endian(crc32(body));
}

enum Kind : std::uint8_t { grey = 0, rgb = 2, palette = 3, grey_alpha = 4, rgba = 6 };

Bytes header(std::uint32_t width, std::uint32_t height, std::uint32_t depth, Kind kind) {
    return bytes_of("\x89PNG\r\n\x1A\n") +
           chunk("IHDR", big_endian(width) + big_endian(height) + big_endian(depth, 1) +
                             big_endian(kind, 1) + big_endian(0, 3));
}

// A file of one row of samples, uncompressed.
Bytes png_row(int width, int depth, Kind kind, const std::vector<std::uint32_t>& samples,
              const Bytes& palette_chunk = {}) {
    Bytes row{std::byte{0}};  // no filter
    for (const std::uint32_t sample : samples) {
        row = row + big_endian(sample, depth / 8);
    }
    const auto size = static_cast<std::uint32_t>(row.size());
    const Bytes zlib = big_endian(0x7801, 2) + big_endian(1, 1) + little_endian(size, 2) +
                       little_endian(~size, 2) + row + big_endian(adler32(row));
    return header(static_cast<std::uint32_t>(width), 1, static_cast<std::uint32_t>(depth), kind) +
           palette_chunk + chunk("IDAT", zlib) + chunk("IEND", {});
}

SrgbImage read(const Bytes& file) {
    const TemporaryFolder folder;
    write_file(folder / "a.png", file);
    return read_png(folder / "a.png");
}

std::vector<Rgba8> pixels_of(const SrgbImage& image) {
    return {image.pixels().begin(), image.pixels().end()};
}

// Every code and no pattern that a filter could hide.
SrgbImage noise(int width, int height, bool opaque) {
    SrgbImage image(width, height);
    std::uint32_t state = 1;
    const auto code = [&] {
        state = state * 1664525 + 1013904223;
        return static_cast<std::uint8_t>(state >> 24);
    };
    for (Rgba8& pixel : image.pixels()) {
        pixel = {code(), code(), code(), opaque ? std::uint8_t{255} : code()};
    }
    return image;
}

TEST_CASE("a picture survives a PNG, with and without alpha") {
    const TemporaryFolder folder;
    for (const bool opaque : {true, false}) {
        for (const auto& [width, height] :
             {std::pair(1, 1), {7, 5}, {300, 200}, {16384, 1}, {1, 16384}}) {
            const SrgbImage image = noise(width, height, opaque);
            write_png(folder / "a.png", image);
            CHECK(read_png(folder / "a.png") == image);
        }
    }
}

TEST_CASE("equal pictures give equal bytes") {
    const TemporaryFolder folder;
    write_png(folder / "a.png", noise(64, 48, false));
    write_png(folder / "b.png", noise(64, 48, false));
    CHECK(read_file(folder / "a.png") == read_file(folder / "b.png"));
}

TEST_CASE("an opaque picture is written as RGB") {
    const TemporaryFolder folder;
    constexpr std::size_t kind = 25;  // where a PNG says it
    write_png(folder / "a.png", noise(4, 4, true));
    CHECK(read_file(folder / "a.png")[kind] == std::byte{rgb});
    write_png(folder / "a.png", noise(4, 4, false));
    CHECK(read_file(folder / "a.png")[kind] == std::byte{rgba});
}

TEST_CASE("every kind of PNG becomes RGBA") {
    CHECK(pixels_of(read(png_row(2, 8, grey, {7, 200}))) ==
          std::vector<Rgba8>{{7, 7, 7, 255}, {200, 200, 200, 255}});
    CHECK(pixels_of(read(png_row(1, 8, grey_alpha, {7, 9}))) == std::vector<Rgba8>{{7, 7, 7, 9}});
    CHECK(pixels_of(read(png_row(1, 8, rgb, {1, 2, 3}))) == std::vector<Rgba8>{{1, 2, 3, 255}});
    CHECK(pixels_of(read(png_row(1, 8, rgba, {1, 2, 3, 4}))) == std::vector<Rgba8>{{1, 2, 3, 4}});
    const Bytes colours = chunk("PLTE", big_endian(0x010203, 3) + big_endian(0x040506, 3));
    CHECK(pixels_of(read(png_row(2, 8, palette, {1, 0}, colours))) ==
          std::vector<Rgba8>{{4, 5, 6, 255}, {1, 2, 3, 255}});
}

TEST_CASE("16 bits are rounded to the nearest of 8") {
    // Code c stands for 257 c; half way to the next is 257 c + 128.5.
    CHECK(pixels_of(read(png_row(1, 16, rgb, {0, 65535, 257 * 100}))) ==
          std::vector<Rgba8>{{0, 255, 100, 255}});
    CHECK(pixels_of(read(png_row(1, 16, rgba, {128, 129, 257 * 100 + 128, 257 * 100 + 129}))) ==
          std::vector<Rgba8>{{0, 1, 100, 101}});
    CHECK(pixels_of(read(png_row(1, 16, grey, {257 * 9 - 129}))) ==
          std::vector<Rgba8>{{8, 8, 8, 255}});
}

TEST_CASE("what is no whole PNG is an error that names the file") {
    const TemporaryFolder folder;
    CHECK_THROWS_WITH_AS(read_png(folder / "none.png"), Contains("No such file"), Error);
    CHECK_THROWS_WITH_AS(read({}), Contains("a.png' is not a PNG file"), Error);
    CHECK_THROWS_WITH_AS(read(bytes_of("GIF89a, which is something else")),
                         Contains("a.png' is not a PNG file"), Error);
    Bytes damaged = png_row(1, 8, rgb, {1, 2, 3});
    damaged[41] = std::byte{0xFF};  // the first byte of the compressed rows
    CHECK_THROWS_WITH_AS(read(damaged), Contains("cannot read PNG '"), Error);
}

TEST_CASE("a PNG that ends early is an error, wherever it ends") {
    const TemporaryFolder folder;
    write_png(folder / "a.png", noise(9, 9, true));
    const Bytes whole = read_file(folder / "a.png");
    for (std::size_t size = 0; size + 12 < whole.size(); ++size) {
        CAPTURE(size);
        CHECK_THROWS_AS(read({whole.begin(), whole.begin() + static_cast<long>(size)}), Error);
    }
}

TEST_CASE("sizes that no file may have") {
    const TemporaryFolder folder;
    CHECK_THROWS_WITH_AS(write_png(folder / "a.png", SrgbImage()), Contains("not 0x0"), Error);
    CHECK_THROWS_WITH_AS(write_png(folder / "a.png", SrgbImage(16385, 1)),
                         Contains("1x1 to 16384x16384 pixels, not 16385x1"), Error);
    CHECK_THROWS_WITH_AS(read(header(16385, 2, 8, rgb) + chunk("IDAT", {})),
                         Contains("not 16385x2"), Error);
    CHECK_THROWS_AS(read(header(0, 0, 8, rgb) + chunk("IDAT", {})), Error);
    CHECK_THROWS_AS(read(header(0x7FFFFFFF, 0x7FFFFFFF, 16, rgba) + chunk("IDAT", {})), Error);
    CHECK(folder.count() == 0);
}

}  // namespace
}  // namespace glint
