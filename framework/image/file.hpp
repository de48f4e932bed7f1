// Whole files in and out. What fails is an Error that names the path and the reason.
#pragma once

#include <cstddef>
#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace glint {

// The widest and the highest picture file that is read or written.
inline constexpr int max_file_side = 16384;

// Error where a picture of this size is empty or beyond max_file_side.
void require_file_size(const std::filesystem::path& path, long long width, long long height);

std::vector<std::byte> read_file(const std::filesystem::path& path);

// All or nothing: the bytes go to a new file beside path, which takes its name when it is complete.
// What is no regular file (/dev/stdout, a pipe) is written to directly.
void write_file(const std::filesystem::path& path, std::span<const std::byte> bytes);

// The same of text, byte by byte.
std::string read_text(const std::filesystem::path& path);
void write_text(const std::filesystem::path& path, std::string_view text);

}  // namespace glint
