#include <algorithm>
#include <nlohmann/json.hpp>
#include <tencer/core/error.hpp>
#include <tencer/core/names.hpp>
#include <tencer/io/curve.hpp>
#include <tencer/io/file.hpp>
#include <tencer/io/write_curves.hpp>

#include "curves/curve_ending.hpp"
#include "design/pretty_json.hpp"
#include "export/dxf_lines.hpp"
#include "text/extension.hpp"
#include "text/text.hpp"

namespace tencer::io {
namespace {

using Curves = std::span<const geometry::Polyline>;

std::string coordinates(const Eigen::Vector3d& point, std::string_view between) {
  return to_text(point.x())
      .append(between)
      .append(to_text(point.y()))
      .append(between)
      .append(to_text(point.z()));
}

// A row a vertex and a blank line between curves; closed ones repeat their first point.
std::string table_text(Curves curves, std::string_view unit, std::string_view between) {
  std::string text = between == "," ? "" : "# unit: " + std::string(unit);
  for (const char* axis : {"x", "y", "z"})
    if (between == ",")
      text.append(text.empty() ? "" : between).append(axis).append(" (").append(unit).append(")");
  text += '\n';
  for (const geometry::Polyline& curve : curves) {
    if (&curve != curves.data()) text += '\n';
    for (int i = 0; i <= curve.edges(); ++i)
      text += coordinates(curve.points.col(i % curve.vertices()), between) + '\n';
  }
  return text;
}

std::string json_text(Curves curves, std::string_view unit) {
  nlohmann::ordered_json list = nlohmann::ordered_json::array();
  for (const geometry::Polyline& curve : curves) {
    nlohmann::ordered_json points = nlohmann::ordered_json::array();
    for (const auto& point : curve.points.colwise())
      points.push_back({point.x(), point.y(), point.z()});
    list.push_back({{"closed", curve.closed}, {"points", points}});
  }
  return pretty({{"unit", unit}, {"curves", list}});
}

std::string vect_text(Curves curves, std::string_view unit) {
  std::string counts;
  std::string colours;
  std::string points;
  int vertices = 0;
  for (const geometry::Polyline& curve : curves) {
    vertices += curve.vertices();
    counts += std::to_string(curve.closed ? -curve.vertices() : curve.vertices()) + " ";
    colours += "0 ";
    for (const auto& point : curve.points.colwise()) points += coordinates(point, " ") + '\n';
  }
  return "VECT # lengths in " + std::string(unit) + "\n" + std::to_string(curves.size()) + " " +
         std::to_string(vertices) + " 0\n" + counts + "\n" + colours + "\n" + points;
}

std::string dxf_curves(Curves curves, std::string_view unit) {
  std::vector<DxfLine> lines;
  for (const geometry::Polyline& curve : curves)
    lines.push_back(
        {.layer = "ROD_" + core::rod_name(static_cast<int>(lines.size())), .line = curve});
  return dxf_text(lines, unit);
}

}  // namespace

std::optional<core::Error> write_curves(const std::filesystem::path& path, Curves curves,
                                        std::string_view unit) {
  core::require(std::ranges::count(curve_units(), unit) > 0, "write_curves: there is no such unit");
  for (const geometry::Polyline& curve : curves)
    core::require(curve.points.allFinite(), "write_curves: needs finite points");
  const auto format = format_by_extension(path);
  if (path.has_extension() && (!format || format == CurveFormat::svg))
    return core::Error{path.string(),
                       "curves in space are not written as " + path.extension().string() +
                           "; let the name end with .obj, .csv, .tsv, .txt, .xyz, .json, .vect "
                           "or .dxf"};
  switch (format.value_or(CurveFormat::obj)) {
    case CurveFormat::table: {
      const std::string ending = lower_extension(path);
      return write_file(path, table_text(curves, unit,
                                         ending == ".csv"   ? ","
                                         : ending == ".tsv" ? "\t"
                                                            : " "));
    }
    case CurveFormat::json:
      return write_file(path, json_text(curves, unit));
    case CurveFormat::vect:
      return write_file(path, vect_text(curves, unit));
    case CurveFormat::dxf:
      return write_file(path, dxf_curves(curves, unit));
    default:
      return write_file(path, obj_text(curves));
  }
}

}  // namespace tencer::io
