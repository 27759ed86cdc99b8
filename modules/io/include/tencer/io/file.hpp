// Whole text files: read at once, written so that nobody ever sees half of one.
#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <tencer/core/error.hpp>

namespace tencer::io {

constexpr std::size_t largest_file = std::size_t{64} << 20;  // bytes

// The bytes of the file or pipe, or of the standard input when the path is "-". Errors: the path,
// and why it cannot be read; devices and files beyond largest_file are not.
core::Expected<std::string> read_file(const std::filesystem::path& path);

// Puts the text in a temporary file in the same folder, closes it and renames it over `path`, so
// that whatever becomes of the program, the path holds the old content or the new one. (A crash of
// the machine may still lose both: nothing waits for the disk.) An Error when that was not
// possible; the old file is then untouched and the temporary one gone. A device or pipe is written
// to as it is.
std::optional<core::Error> write_file(const std::filesystem::path& path, std::string_view text);

struct NamedText {
  std::string name;
  std::string text;
};

// All of them into `folder`, the one that matters most first. On an Error everything is as it was
// before. A folder that is not there appears at once with all its files, so that a program that is
// killed leaves the whole folder or none. In one that is there, a program that is killed leaves the
// first file, old or new, and of the others only such as go with it; all of them, old and new, are
// then also there under longer names (.old, .part).
std::optional<core::Error> write_files(const std::filesystem::path& folder,
                                       std::span<const NamedText> files);

// Why write_files could not write into this folder, found by trying; leaves nothing behind. For
// those who would rather know before they work for an hour.
std::optional<core::Error> folder_problem(const std::filesystem::path& folder);

}  // namespace tencer::io
