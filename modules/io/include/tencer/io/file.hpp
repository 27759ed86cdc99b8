// Whole text files: read at once, written so that nobody ever sees half of one.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <tencer/core/error.hpp>

namespace tencer::io {

// The file's bytes. Errors: the path, and why it cannot be read.
core::Expected<std::string> read_file(const std::filesystem::path& path);

// Puts the text in a temporary file in the same folder, flushes it and renames it over
// `path`, so the path holds the old content or the new one. An Error when that was not possible;
// the old file is then untouched and the temporary one gone.
std::optional<core::Error> write_file(const std::filesystem::path& path, std::string_view text);

}  // namespace tencer::io
