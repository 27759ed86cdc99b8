// Curve files written, in the format of the name's ending; curve.hpp reads them.
#pragma once

#include <filesystem>
#include <optional>
#include <span>
#include <string_view>
#include <tencer/core/error.hpp>
#include <tencer/geometry/polyline.hpp>

namespace tencer::io {

// As OBJ (also without an ending), a table (.csv, .tsv, .txt, .xyz, .dat, .pts), .json, .vect or
// .dxf. read_curves gives the same doubles back. unit: of curve_units(), which the file names but
// for OBJ and VECT. An Error where the ending is another, or when it cannot be written. Requires
// finite points.
std::optional<core::Error> write_curves(const std::filesystem::path& path,
                                        std::span<const geometry::Polyline> curves,
                                        std::string_view unit);

}  // namespace tencer::io
