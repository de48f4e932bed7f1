#include "framework/image/png.hpp"

#include "framework/image/file.hpp"
#include "framework/math/error.hpp"

#include <algorithm>
#include <cstdlib>
#include <cstring>
#include <limits>
#include <memory>
#include <string>

// stb's functions stay inside this file; its style is its own.
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wconversion"
#pragma GCC diagnostic ignored "-Wsign-conversion"
#pragma GCC diagnostic ignored "-Wshadow"
#pragma GCC diagnostic ignored "-Wunused-function"
#pragma GCC diagnostic ignored "-Wmissing-field-initializers"
#define STB_IMAGE_IMPLEMENTATION
#define STB_IMAGE_STATIC
#define STBI_ONLY_PNG
#define STBI_NO_STDIO
#define STBI_FAILURE_USERMSG
#include <stb/stb_image.h>
#define STB_IMAGE_WRITE_IMPLEMENTATION
#define STB_IMAGE_WRITE_STATIC
#define STBI_WRITE_NO_STDIO
#include <stb/stb_image_write.h>
#pragma GCC diagnostic pop

namespace glint {
namespace fs = std::filesystem;
namespace {

struct Free {
    void operator()(void* memory) const { std::free(memory); }
};

// A file in memory, as stb takes it.
struct Encoded {
    const stbi_uc* bytes;
    int size;
};

[[noreturn]] void fail(const fs::path& path) {
    throw Error("cannot read PNG '" + path.string() + "': " + stbi_failure_reason());
}

SrgbImage decode8(const fs::path& path, Encoded file) {
    int width = 0;
    int height = 0;
    int channels = 0;
    const std::unique_ptr<stbi_uc, Free> codes(
        stbi_load_from_memory(file.bytes, file.size, &width, &height, &channels, 4));
    if (!codes) {
        fail(path);
    }
    SrgbImage image(width, height);
    std::memcpy(image.pixels().data(), codes.get(), image.pixels().size_bytes());
    return image;
}

std::uint8_t to_8_bits(stbi_us code) {
    return static_cast<std::uint8_t>((code + 128) / 257);  // 65535 = 257 * 255
}

SrgbImage decode16(const fs::path& path, Encoded file) {
    int width = 0;
    int height = 0;
    int channels = 0;
    const std::unique_ptr<stbi_us, Free> codes(
        stbi_load_16_from_memory(file.bytes, file.size, &width, &height, &channels, 4));
    if (!codes) {
        fail(path);
    }
    SrgbImage image(width, height);
    const stbi_us* code = codes.get();
    for (Rgba8& pixel : image.pixels()) {
        pixel = {to_8_bits(code[0]), to_8_bits(code[1]), to_8_bits(code[2]), to_8_bits(code[3])};
        code += 4;
    }
    return image;
}

bool is_opaque(const SrgbImage& image) {
    return std::ranges::all_of(image.pixels(), [](const Rgba8& p) { return p.a == 255; });
}

std::vector<std::uint8_t> without_alpha(const SrgbImage& image) {
    std::vector<std::uint8_t> codes;
    codes.reserve(image.pixels().size() * 3);
    for (const Rgba8& p : image.pixels()) {
        codes.insert(codes.end(), {p.r, p.g, p.b});
    }
    return codes;
}

void append(void* file, void* bytes, int size) {
    const auto* first = static_cast<const std::byte*>(bytes);
    auto& all = *static_cast<std::vector<std::byte>*>(file);
    all.insert(all.end(), first, first + size);
}

}  // namespace

SrgbImage read_png(const fs::path& path) {
    const std::vector<std::byte> bytes = read_file(path);
    constexpr unsigned char signature[] = {0x89, 'P', 'N', 'G', '\r', '\n', 0x1A, '\n'};
    if (bytes.size() < sizeof signature ||
        std::memcmp(bytes.data(), signature, sizeof signature) != 0) {
        throw Error("'" + path.string() + "' is not a PNG file");
    }
    if (bytes.size() > std::numeric_limits<int>::max()) {
        throw Error("'" + path.string() + "' is larger than 2 GiB");
    }
    const Encoded file{reinterpret_cast<const stbi_uc*>(bytes.data()),
                       static_cast<int>(bytes.size())};
    int width = 0;
    int height = 0;
    int channels = 0;
    if (stbi_info_from_memory(file.bytes, file.size, &width, &height, &channels) == 0) {
        fail(path);
    }
    require_file_size(path, width, height);
    return stbi_is_16_bit_from_memory(file.bytes, file.size) != 0 ? decode16(path, file)
                                                                  : decode8(path, file);
}

std::vector<std::byte> encode_png(const SrgbImage& image) {
    std::vector<std::byte> file;
    constexpr int packed = 0;  // rows follow each other without a gap
    int done = 0;
    if (is_opaque(image)) {
        const auto codes = without_alpha(image);
        done = stbi_write_png_to_func(append, &file, image.width(), image.height(), 3, codes.data(),
                                      packed);
    } else {
        done = stbi_write_png_to_func(append, &file, image.width(), image.height(), 4,
                                      image.pixels().data(), packed);
    }
    if (done == 0) {
        throw std::bad_alloc();
    }
    return file;
}

void write_png(const fs::path& path, const SrgbImage& image) {
    require_file_size(path, image.width(), image.height());
    write_file(path, encode_png(image));
}

}  // namespace glint
