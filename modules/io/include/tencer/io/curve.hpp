// Curve files: target curves in, poses out.
//
// The format goes by the extension:
//   .obj              `v x y z` and `l i j k ...` (indices from 1; negative ones count back from
//   the
//                     last vertex so far). Elements that share an end vertex are joined, so that a
//                     file with one element an edge works; every chain is a curve, and closed when
//                     it returns to its first vertex. A file without `l` holds one curve through
//                     its vertices in order. Faces are not curves and are refused.
//   .csv, .xyz, .txt  x, y, z a line, separated by commas, semicolons or blanks; `#` starts a
//                     comment; a first line without numbers is a header; blank lines separate
//                     curves.
//   .json             {"curves": [{"closed": bool, "points": [[x, y, z], ...]}, ...]}, or one curve
//                     as a bare array of points.
//
// In all of them a curve whose last point repeats its first is closed and the repeated point is
// left out; so it is when the ends are within 1 % of the mean edge. Points that repeat the one
// before them (within 1e-9 of the curve's bounding-box diagonal) are dropped. Both are noted, and
// so is an open curve whose ends are as near as neighbours. An explicit "closed": false with ends
// that meet is an error. So are numbers that are not finite, a curve of one point, a closed one of
// fewer than three, and an edge that turns straight back along the one before it, where the
// curvature is infinite.
//
// Decimal commas are read where blanks or semicolons separate; UTF-16 is read as ASCII. A header or
// comment at the start of a table that names a unit, "x (mm)" or "unit: mm", is the length unit.
#pragma once

#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <tencer/core/error.hpp>
#include <tencer/geometry/polyline.hpp>
#include <vector>

namespace tencer::io {

struct CurveFile {
  std::vector<geometry::Polyline> curves{};  // at least one
  std::optional<std::string> length_unit{};  // when the file names one: mm, cm, m
  std::vector<std::string> notes{};          // what was taken otherwise than it stands there
};

core::Expected<CurveFile> read_curve_file(const std::filesystem::path& path);

// Joins the end of an open curve to its start by an edge. Set: why not, as where the ends are
// further apart than three times the longest edge.
[[nodiscard]] std::optional<std::string> close_curve(geometry::Polyline& curve);

// The curves of the file alone, at least one. Errors: "file:line" (text formats) or "file: key"
// (JSON).
core::Expected<std::vector<geometry::Polyline>> read_curves(const std::filesystem::path& path);

// The text of an OBJ file with one `l` a curve, the first index repeated when closed; read_curves
// gives the same doubles back. Requires finite points.
std::string obj_text(std::span<const geometry::Polyline> curves);
std::optional<core::Error> write_obj(const std::filesystem::path& path,
                                     std::span<const geometry::Polyline> curves);

}  // namespace tencer::io
