// PNG files of 8-bit sRGB pictures.
#pragma once

#include "framework/image/image.hpp"

#include <cstddef>
#include <filesystem>
#include <vector>

namespace glint {

// Grey, palette, RGB and 16-bit files are converted; 16 bits are rounded to the nearest of 8.
// Code values are taken as sRGB whatever profile the file names. Error: no such file, no PNG,
// damaged, more than max_file_side pixels wide or high.
SrgbImage read_png(const std::filesystem::path& path);

// The bytes of a file. RGB where every pixel is opaque, else RGBA. The picture is not empty.
std::vector<std::byte> encode_png(const SrgbImage& image);

// RGB where every pixel is opaque, else RGBA. Equal pictures give equal bytes; the file appears
// complete or not at all. Error: cannot be written, empty or larger than max_file_side.
void write_png(const std::filesystem::path& path, const SrgbImage& image);

}  // namespace glint
