// Files that readers of this module take as text.
#pragma once

#include <filesystem>
#include <string>

namespace tencer::io {

// The file's name for messages; "standard input" for "-".
std::string shown(const std::filesystem::path& path);

// What is named after the file: its name without its ending, "stdin" for "-".
std::string stem(const std::filesystem::path& path);

// The file as ASCII or UTF-8; what begins with the mark of UTF-16 becomes that, with a question
// mark for what is not ASCII, which no number holds. Throws BadInput when the file cannot be read
// or is no text.
std::string read_text(const std::filesystem::path& path);

}  // namespace tencer::io
