#include "framework/image/pfm.hpp"

#include "framework/image/file.hpp"
#include "framework/math/error.hpp"
#include "tests/temporary.hpp"
#include "tests/unit/image/bytes.hpp"

#include <doctest/doctest.h>

#include <bit>
#include <limits>

namespace glint {
namespace {

using doctest::Contains;

constexpr std::uint32_t one = 0x3F800000;
constexpr std::uint32_t two = 0x40000000;
constexpr std::uint32_t signalling_nan = 0x7F812345;
constexpr std::uint32_t negative_nan = 0xFFC00001;

LinearImage read(const Bytes& file) {
    const TemporaryFolder folder;
    write_file(folder / "a.pfm", file);
    return read_pfm(folder / "a.pfm");
}

LinearImage read(const std::string& head, const Bytes& values) {
    return read(bytes_of(head) + values);
}

// The bits of all values, for NaN is not equal to itself.
template <class Pixel>
std::vector<std::uint32_t> bits_of_image(const Image<Pixel>& image) {
    const auto bytes = std::as_bytes(image.pixels());
    std::vector<std::uint32_t> bits(bytes.size() / sizeof(std::uint32_t));
    std::memcpy(bits.data(), bytes.data(), bytes.size());
    return bits;
}

// Values of every kind: ordinary, beyond 0..1, denormal, infinite, negative zero, NaN.
template <class Pixel>
Image<Pixel> varied(int width, int height) {
    constexpr std::uint32_t kinds[] = {
        one,          0xC2F60000, 1, 0x7F800000, 0xFF800000, 0x80000000, signalling_nan,
        negative_nan, 0x7F7FFFFF};
    Image<Pixel> image(width, height);
    std::vector<std::uint32_t> bits(image.pixels().size_bytes() / sizeof(std::uint32_t));
    for (std::size_t i = 0; i < bits.size(); ++i) {
        bits[i] = kinds[i * 7 % std::size(kinds)] + static_cast<std::uint32_t>(i % 16);
    }
    std::memcpy(static_cast<void*>(image.pixels().data()), bits.data(), bits.size() * 4);
    return image;
}

TEST_CASE("every bit survives a PFM, colour and grey") {
    const TemporaryFolder folder;
    for (const auto& [width, height] :
         {std::pair(1, 1), {3, 5}, {64, 48}, {16384, 1}, {1, 16384}}) {
        const auto colour = varied<Rgb<float>>(width, height);
        write_pfm(folder / "a.pfm", colour);
        CHECK(bits_of_image(read_pfm(folder / "a.pfm")) == bits_of_image(colour));
        const auto grey = varied<float>(width, height);
        write_pfm(folder / "a.pfm", grey);
        CHECK(bits_of_image(read_pfm_grey(folder / "a.pfm")) == bits_of_image(grey));
    }
    CHECK(folder.count() == 1);
}

TEST_CASE("the file is the text and the floats that the format names, bottom row first") {
    const TemporaryFolder folder;
    Image<float> image(1, 2);
    image(0, 0) = 1.0F;  // top
    image(0, 1) = 2.0F;
    write_pfm(folder / "a.pfm", image);
    CHECK(read_file(folder / "a.pfm") ==
          bytes_of("Pf\n1 2\n-1.0\n") + little_endian(two) + little_endian(one));
}

TEST_CASE("the sign of the scale is the byte order") {
    const Bytes little = little_endian(one) + little_endian(two) + little_endian(negative_nan);
    const Bytes big = big_endian(one) + big_endian(two) + big_endian(negative_nan);
    const std::vector<std::uint32_t> expected{one, two, negative_nan};
    for (const char* scale : {"-1", "-1.0", "-2.5e3", "-0.001"}) {
        CHECK(bits_of_image(read("PF\n1 1\n" + std::string(scale) + "\n", little)) == expected);
    }
    for (const char* scale : {"1", "1.0", "+1.0", "2.5e3"}) {
        CHECK(bits_of_image(read("PF\n1 1\n" + std::string(scale) + "\n", big)) == expected);
    }
}

TEST_CASE("a grey file fills all three channels") {
    const LinearImage image = read("Pf 1 1 -1\n", little_endian(two));
    CHECK(image(0, 0) == Rgb<float>(2.0F));
}

TEST_CASE("a header may use any white space") {
    const Bytes value = little_endian(two);
    for (const char* head : {"Pf 1 1 -1 ", "Pf\t1\t1\t-1\t", "Pf\r\n1 1\r\n-1.0\r\n",
                             "Pf\n\n  1 \n 1 \n\n -1.0\n", "Pf\v1\f1 -1\r", "Pf\n+1 +1\n-1\n"}) {
        CAPTURE(head);
        CHECK(read(head, value)(0, 0) == Rgb<float>(2.0F));
    }
}

TEST_CASE("values that look like white space are values") {
    const Bytes value = bytes_of("\n\r\n ");
    const std::vector<std::uint32_t> expected(3, 0x200A0D0A);
    CHECK(bits_of_image(read("Pf 1 1 -1\n", value)) == expected);
    CHECK(bits_of_image(read("Pf 1 1 -1\r\n", value)) == expected);
    CHECK(bits_of_image(read("Pf 1 1 -1\r", value)) == expected);
}

TEST_CASE("a bad header is an error that says what is bad") {
    const Bytes value = little_endian(one);
    CHECK_THROWS_WITH_AS(read({}), Contains("a.pfm' is not a PFM file"), Error);
    for (const char* head : {"P6 1 1 255\n", "P", "PF", "Pfm 1 1 -1\n", "pf 1 1 -1\n"}) {
        CAPTURE(head);
        CHECK_THROWS_WITH_AS(read(head, {}), Contains("is not a PFM file"), Error);
    }
    for (const char* head : {"Pf ", "Pf x 1 -1\n", "Pf 1.5 1 -1\n", "Pf # no\n1 1 -1\n",
                             "Pf 99999999999999999999 1 -1\n", "Pf + 1 -1\n"}) {
        CAPTURE(head);
        CHECK_THROWS_WITH_AS(read(head, {}), Contains("no valid width"), Error);
    }
    CHECK_THROWS_WITH_AS(read("Pf 1 y -1\n", value), Contains("no valid height"), Error);
    for (const char* head : {"Pf 1 1 ", "Pf 1 1 0\n", "Pf 1 1 -0.0\n", "Pf 1 1 nan\n",
                             "Pf 1 1 -inf\n", "Pf 1 1 -1x\n", "Pf 1 1 +-1\n", "Pf 1 1 1e999\n"}) {
        CAPTURE(head);
        CHECK_THROWS_WITH_AS(read(head, {}), Contains("no valid scale"), Error);
    }
}

TEST_CASE("sizes that no file may have") {
    const TemporaryFolder folder;
    for (const char* size : {"0 1", "1 0", "-1 1", "16385 1", "1 16385", "4294967297 1"}) {
        CAPTURE(size);
        CHECK_THROWS_WITH_AS(read("Pf " + std::string(size) + " -1\n", {}),
                             Contains("a picture file holds 1x1 to 16384x16384 pixels"), Error);
    }
    CHECK_THROWS_AS(write_pfm(folder / "a.pfm", LinearImage()), Error);
    CHECK_THROWS_AS(write_pfm(folder / "a.pfm", Image<float>(16385, 1)), Error);
    CHECK(folder.count() == 0);
}

TEST_CASE("too few or too many values are an error") {
    CHECK_THROWS_WITH_AS(read("Pf 1 1 -1", {}), Contains("it ends after its header"), Error);
    CHECK_THROWS_WITH_AS(read("Pf 1 1 -1\n", {}),
                         Contains("announces 4 bytes of values, it holds 0"), Error);
    CHECK_THROWS_WITH_AS(read("Pf 1 1 -1\n", big_endian(0, 3)), Contains("it holds 3"), Error);
    CHECK_THROWS_WITH_AS(read("Pf 1 1 -1\n", big_endian(one) + big_endian(0, 1)),
                         Contains("it holds 5"), Error);
    CHECK_THROWS_WITH_AS(read("PF 16384 16384 -1\n", {}), Contains("announces 3221225472"), Error);
}

TEST_CASE("a colour file is not taken for a grey one") {
    const TemporaryFolder folder;
    write_pfm(folder / "a.pfm", LinearImage(1, 1));
    CHECK_THROWS_WITH_AS(read_pfm_grey(folder / "a.pfm"), Contains("it is in colour"), Error);
    CHECK_THROWS_WITH_AS(read_pfm(folder / "b.pfm"), Contains("No such file"), Error);
}

}  // namespace
}  // namespace glint
