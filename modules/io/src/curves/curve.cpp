#include <algorithm>
#include <cctype>
#include <tencer/core/error.hpp>
#include <tencer/io/curve.hpp>
#include <tencer/io/file.hpp>
#include <utility>

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

// Bytes as ASCII or UTF-8, from UTF-16 when they begin with its mark; what is not ASCII in that
// becomes a question mark, which no number holds.
std::string plain_text(std::string bytes, const std::string& file) {
  const bool little = bytes.starts_with("\xFF\xFE");
  if (little || bytes.starts_with("\xFE\xFF")) {
    std::string text;
    for (std::size_t i = 2; i + 1 < bytes.size(); i += 2) {
      const char low = bytes[little ? i : i + 1];
      const char high = bytes[little ? i + 1 : i];
      text += high == 0 && static_cast<unsigned char>(low) < 128 ? low : '?';
    }
    return text;
  }
  if (bytes.find('\0') != std::string::npos)
    fail(file, "is not text: it holds NUL bytes; save it as plain text, in UTF-8");
  return bytes;
}

}  // namespace

core::Expected<CurveFile> read_curve_file(const std::filesystem::path& path) {
  return guarded([&] {
    const std::string file = path.string();
    const std::string text = plain_text(value_or_fail(read_file(path)), file);
    const std::string extension = lower_extension(path);
    if (extension == ".obj") return parse_obj(text, file);
    if (extension == ".csv" || extension == ".xyz" || extension == ".txt")
      return parse_table(text, file);
    if (extension == ".json") return parse_curve_json(text, file);
    fail(file,
         "unknown kind of curve file '" + extension + "'; use .obj, .csv, .xyz, .txt or .json");
  });
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
