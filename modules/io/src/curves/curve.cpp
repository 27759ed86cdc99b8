#include <algorithm>
#include <array>
#include <tencer/core/error.hpp>
#include <tencer/io/curve.hpp>
#include <tencer/io/file.hpp>
#include <utility>

#include "curves/curve_format.hpp"
#include "text/bad_input.hpp"
#include "text/read_text.hpp"
#include "text/text.hpp"

namespace tencer::io {
namespace {

struct CurveUnit {
  std::string_view name;
  std::string_view scene_unit;
  double size = 1.0;  // in that
};
constexpr std::array known_units{CurveUnit{"mm", "mm", 1}, CurveUnit{"cm", "cm", 1},
                                 CurveUnit{"m", "m", 1}, CurveUnit{"in", "cm", 2.54},
                                 CurveUnit{"ft", "cm", 30.48}};

}  // namespace

core::Expected<CurveFile> read_curve_file(const std::filesystem::path& path) {
  return guarded([&] { return parse_curves(path, read_text(path), shown(path)); });
}

std::span<const std::string_view> curve_units() {
  static constexpr auto names = [] {
    std::array<std::string_view, known_units.size()> result{};
    for (std::size_t i = 0; i < result.size(); ++i) result[i] = known_units[i].name;
    return result;
  }();
  return names;
}

void take_unit(CurveFile& file, std::string_view unit) {
  const auto* known = std::ranges::find(known_units, unit, &CurveUnit::name);
  core::require(known != known_units.end(), "take_unit: expected mm, cm, m, in or ft");
  for (geometry::Polyline& curve : file.curves) curve.points *= known->size;
  file.length_unit = known->scene_unit;
}

core::Expected<std::vector<geometry::Polyline>> read_curves(const std::filesystem::path& path) {
  auto file = read_curve_file(path);
  if (!file) return file.error();
  return std::move(file->curves);
}

std::string obj_text(std::span<const geometry::Polyline> curves) {
  std::string text;
  int first = 1;
  for (const geometry::Polyline& curve : curves) {
    core::require(curve.points.allFinite(), "obj_text: needs finite points");
    for (int i = 0; i < curve.vertices(); ++i) {
      text += 'v';
      for (const double coordinate : curve.points.col(i))
        text.append(1, ' ').append(to_text(coordinate));
      text += '\n';
    }
    text += 'l';
    for (int i = 0; i < curve.vertices() + (curve.closed ? 1 : 0); ++i)
      text.append(1, ' ').append(std::to_string(first + i % curve.vertices()));
    text += '\n';
    first += curve.vertices();
  }
  return text;
}

std::optional<core::Error> write_obj(const std::filesystem::path& path,
                                     std::span<const geometry::Polyline> curves) {
  return write_file(path, obj_text(curves));
}

}  // namespace tencer::io
