#include <algorithm>
#include <cctype>
#include <tencer/core/error.hpp>
#include <tencer/io/curve.hpp>
#include <tencer/io/file.hpp>

#include "curves/curve_json.hpp"
#include "curves/curve_obj.hpp"
#include "curves/curve_table.hpp"
#include "text/bad_input.hpp"
#include "text/text.hpp"

namespace tencer::io {
namespace {

std::string lower_extension(const std::filesystem::path& path) {
  std::string extension = path.extension().string();
  std::ranges::transform(extension, extension.begin(),
                         [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return extension;
}

}  // namespace

core::Expected<std::vector<geometry::Polyline>> read_curves(const std::filesystem::path& path) {
  return guarded([&] {
    const std::string text = value_or_fail(read_file(path));
    const std::string file = path.string();
    const std::string extension = lower_extension(path);
    if (extension == ".obj") return parse_obj(text, file);
    if (extension == ".csv" || extension == ".xyz" || extension == ".txt")
      return parse_table(text, file);
    if (extension == ".json") return parse_curve_json(text, file);
    fail(file,
         "unknown kind of curve file '" + extension + "'; use .obj, .csv, .xyz, .txt or .json");
  });
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
