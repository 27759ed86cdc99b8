// Curve files: target curves in, poses out. docs/curves.md has the formats, what is taken of each
// and what is refused: OBJ, tables of coordinates, JSON, Geomview VECT, SVG and DXF, and designs,
// of which the rods' targets are the curves.
//
// The format goes by the extension, and where that says nothing by the content. In all of them a
// curve whose last point repeats its first is closed and the repeated point is left out; so it is
// when the ends are within 1 % of the mean edge. Points that repeat the one before them (within
// 1e-9 of the curve's bounding-box diagonal) are dropped. Both are noted, and so is an open curve
// whose ends are as near as neighbours. A file that says "closed": false of a curve whose ends meet
// is an error. So are numbers that are not finite, a curve of one point, a closed one of fewer than
// three, and an edge that turns straight back along the one before it, where the curvature is
// infinite.
#pragma once

#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <tencer/core/error.hpp>
#include <tencer/geometry/polyline.hpp>
#include <vector>

namespace tencer::io {

struct CurveFile {
  std::vector<geometry::Polyline> curves{};  // at least one
  std::optional<std::string> length_unit{};  // of curve_units(), when the file names one
  std::vector<std::string> notes{};          // what was taken otherwise than it stands there
  std::vector<std::string> open_ends{};      // curves that are open, but may be meant to be closed
};

// A path "-" is the standard input. Errors: "file:line" (text formats) or "file: key" (JSON).
core::Expected<CurveFile> read_curve_file(const std::filesystem::path& path);

// The curves of the file alone, at least one.
core::Expected<std::vector<geometry::Polyline>> read_curves(const std::filesystem::path& path);

// The curve through points (3 x n), looked at as those of files are; `closed` as files say it.
// Errors begin with `name`.
core::Expected<CurveFile> listed_curve(const Eigen::Ref<const Eigen::Matrix3Xd>& points,
                                       std::optional<bool> closed, const std::string& name);

// Units that the numbers of a curve may be in: mm, cm, m, in, ft.
std::span<const std::string_view> curve_units();

// Takes the numbers to be in this one of curve_units(), and makes length_unit one of a scene: these
// have no inches and feet, so such curves are scaled to cm.
void take_unit(CurveFile& file, std::string_view unit);

// Joins the end of an open curve to its start by an edge. Set: why not, as where the ends are
// further apart than three times the longest edge.
[[nodiscard]] std::optional<std::string> close_curve(geometry::Polyline& curve);

// The text of an OBJ file with one `l` a curve, the first index repeated when closed; read_curves
// gives the same doubles back. Requires finite points.
std::string obj_text(std::span<const geometry::Polyline> curves);
std::optional<core::Error> write_obj(const std::filesystem::path& path,
                                     std::span<const geometry::Polyline> curves);

}  // namespace tencer::io
