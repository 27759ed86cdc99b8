// The formats of curve files and how they are told apart.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <tencer/io/curve.hpp>

namespace tencer::io {

enum class CurveFormat { obj, table, json, vect, svg, dxf };

// By the extension, or else by how the text begins. Throws BadInput for files that are known to be
// something else, with what to do about it.
CurveFormat format_of(const std::filesystem::path& path, std::string_view text,
                      const std::string& file);

// The curves of a text in any of the formats; throws BadInput. `file` is the name for its places.
CurveFile parse_curves(const std::filesystem::path& path, std::string_view text,
                       const std::string& file);

}  // namespace tencer::io
