#include "text/read_text.hpp"

#include <tencer/io/file.hpp>
#include <utility>

#include "text/bad_input.hpp"

namespace tencer::io {
namespace {

std::string from_utf16(const std::string& bytes, bool little) {
  std::string text;
  for (std::size_t i = 2; i + 1 < bytes.size(); i += 2) {
    const char low = bytes[little ? i : i + 1];
    const char high = bytes[little ? i + 1 : i];
    text += high == 0 && static_cast<unsigned char>(low) < 128 ? low : '?';
  }
  return text;
}

}  // namespace

std::string shown(const std::filesystem::path& path) {
  return path == "-" ? "standard input" : path.string();
}

std::string stem(const std::filesystem::path& path) {
  return path == "-" ? "stdin" : path.stem().string();
}

std::string read_text(const std::filesystem::path& path) {
  std::string bytes = value_or_fail(read_file(path));
  const bool little = bytes.starts_with("\xFF\xFE");
  if (little || bytes.starts_with("\xFE\xFF")) return from_utf16(bytes, little);
  if (bytes.find('\0') != std::string::npos)
    fail(shown(path), "is not text: it holds NUL bytes; save it as plain text, in UTF-8");
  return bytes;
}

}  // namespace tencer::io
