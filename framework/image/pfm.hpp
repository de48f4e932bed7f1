// PFM files: linear float values, unclamped, bit for bit (NaN and infinity too). Paul Debevec's
// "portable float map": a header of text, "PF" for colour or "Pf" for grey, width, height and a
// scale whose sign is the byte order, then rows from the bottom.
#pragma once

#include "framework/image/image.hpp"

#include <filesystem>

namespace glint {

// Either byte order; the magnitude of the scale is not applied. Grey becomes r = g = b.
// Error: no such file, a bad header, more than max_file_side pixels wide or high, or not exactly
// the bytes that the header announces.
LinearImage read_pfm(const std::filesystem::path& path);

// As above; a colour file is an Error.
Image<float> read_pfm_grey(const std::filesystem::path& path);

// Little-endian. The file appears complete or not at all. Error: cannot be written, empty or larger
// than max_file_side.
void write_pfm(const std::filesystem::path& path, const LinearImage& image);
void write_pfm(const std::filesystem::path& path, const Image<float>& image);

}  // namespace glint
