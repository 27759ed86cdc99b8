// The endings of names.
#pragma once

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <string>

namespace tencer::io {

// ".obj" of "knot.OBJ"; "" of a name that has none.
inline std::string lower_extension(const std::filesystem::path& path) {
  std::string extension = path.extension().string();
  std::ranges::transform(extension, extension.begin(),
                         [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return extension;
}

}  // namespace tencer::io
