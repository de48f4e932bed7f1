#include "framework/image/pfm.hpp"

#include "framework/image/file.hpp"
#include "framework/math/error.hpp"

#include <algorithm>
#include <bit>
#include <charconv>
#include <cmath>
#include <cstring>
#include <string>
#include <string_view>

namespace glint {
namespace fs = std::filesystem;
namespace {

static_assert(std::endian::native == std::endian::little);
static_assert(sizeof(Rgb<float>) == 3 * sizeof(float));

struct Pfm {
    int width;
    int height;
    int channels;               // 1 or 3
    std::vector<float> values;  // in the file's order
};

[[noreturn]] void fail(const fs::path& path, const std::string& reason) {
    throw Error("cannot read PFM '" + path.string() + "': " + reason);
}

bool is_space(char c) {
    return c == ' ' || (c >= '\t' && c <= '\r');
}

// Takes white space and then a word off the front.
std::string_view take_word(std::string_view& text) {
    const auto* first = std::ranges::find_if_not(text, is_space);
    const auto* last = std::find_if(first, text.end(), is_space);
    const std::string_view word(first, last);
    text = {last, text.end()};
    return word;
}

template <class Number>
Number take_number(const fs::path& path, std::string_view& text, const char* name) {
    const std::string_view word = take_word(text);
    // from_chars does not know a plus sign.
    const std::size_t plus = word.starts_with('+') && !word.starts_with("+-") ? 1 : 0;
    Number number{};
    const char* last = word.data() + word.size();
    const auto [end, error] = std::from_chars(word.data() + plus, last, number);
    if (word.size() == plus || error != std::errc() || end != last) {
        fail(path, std::string("its header has no valid ") + name);
    }
    return number;
}

// One white space stands before the values; where the file is a byte too long it was a CR LF.
void skip_line_end(const fs::path& path, std::string_view& text, std::size_t size) {
    text.remove_prefix(text.starts_with("\r\n") && text.size() == size + 2 ? 2 : 1);
    if (text.size() != size) {
        fail(path, "its header announces " + std::to_string(size) + " bytes of values, it holds " +
                       std::to_string(text.size()));
    }
}

void swap_bytes(std::vector<float>& values) {
    for (float& value : values) {
        std::uint32_t bits = 0;
        std::memcpy(&bits, &value, sizeof bits);
        bits = __builtin_bswap32(bits);
        std::memcpy(&value, &bits, sizeof bits);
    }
}

Pfm read(const fs::path& path) {
    const std::vector<std::byte> bytes = read_file(path);
    std::string_view text(reinterpret_cast<const char*>(bytes.data()), bytes.size());
    const std::string_view kind = text.substr(0, 2);
    if (kind != "PF" && kind != "Pf") {
        throw Error("'" + path.string() + "' is not a PFM file");
    }
    text.remove_prefix(2);
    if (text.empty() || !is_space(text.front())) {
        throw Error("'" + path.string() + "' is not a PFM file");
    }
    const auto width = take_number<long long>(path, text, "width");
    const auto height = take_number<long long>(path, text, "height");
    const auto scale = take_number<double>(path, text, "scale");
    if (scale == 0.0 || !std::isfinite(scale)) {
        fail(path, "its header has no valid scale");
    }
    require_file_size(path, width, height);
    Pfm pfm{static_cast<int>(width), static_cast<int>(height), kind == "PF" ? 3 : 1, {}};
    const auto count = static_cast<std::size_t>(width * height * pfm.channels);
    if (text.empty()) {
        fail(path, "it ends after its header");
    }
    skip_line_end(path, text, count * sizeof(float));
    pfm.values.resize(count);
    std::memcpy(pfm.values.data(), text.data(), text.size());
    if (scale > 0.0) {
        swap_bytes(pfm.values);
    }
    return pfm;
}

template <class Pixel>
Image<Pixel> bottom_up(const Pfm& pfm) {
    Image<Pixel> image(pfm.width, pfm.height);
    const float* from = pfm.values.data();
    for (int y = pfm.height - 1; y >= 0; --y) {
        const auto row = image.row(y);
        std::memcpy(static_cast<void*>(row.data()), from, row.size_bytes());
        from += row.size_bytes() / sizeof(float);
    }
    return image;
}

template <class Pixel>
void write(const fs::path& path, const Image<Pixel>& image, const std::string& kind) {
    require_file_size(path, image.width(), image.height());
    const std::string header = kind + "\n" + std::to_string(image.width()) + " " +
                               std::to_string(image.height()) + "\n-1.0\n";
    const auto text = std::as_bytes(std::span(header));
    std::vector<std::byte> bytes(text.begin(), text.end());
    bytes.reserve(text.size() + image.pixels().size_bytes());
    for (int y = image.height() - 1; y >= 0; --y) {
        const auto row = std::as_bytes(image.row(y));
        bytes.insert(bytes.end(), row.begin(), row.end());
    }
    write_file(path, bytes);
}

}  // namespace

LinearImage read_pfm(const fs::path& path) {
    const Pfm pfm = read(path);
    if (pfm.channels == 3) {
        return bottom_up<Rgb<float>>(pfm);
    }
    const Image<float> grey = bottom_up<float>(pfm);
    LinearImage image(pfm.width, pfm.height);
    std::ranges::transform(grey.pixels(), image.pixels().begin(),
                           [](float value) { return Rgb<float>(value); });
    return image;
}

Image<float> read_pfm_grey(const fs::path& path) {
    const Pfm pfm = read(path);
    if (pfm.channels != 1) {
        fail(path, "it is in colour, wanted is a grey one");
    }
    return bottom_up<float>(pfm);
}

void write_pfm(const fs::path& path, const LinearImage& image) {
    write(path, image, "PF");
}

void write_pfm(const fs::path& path, const Image<float>& image) {
    write(path, image, "Pf");
}

}  // namespace glint
