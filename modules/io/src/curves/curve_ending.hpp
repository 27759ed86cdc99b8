// The formats of curve files by their names alone.
#pragma once

#include <filesystem>
#include <optional>

#include "curves/curve_format.hpp"

namespace tencer::io {

// Not set: the extension is none of a curve file.
std::optional<CurveFormat> format_by_extension(const std::filesystem::path& path);

}  // namespace tencer::io
