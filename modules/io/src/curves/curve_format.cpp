#include "curves/curve_format.hpp"

#include <algorithm>
#include <array>
#include <optional>

#include "curves/curve_dxf.hpp"
#include "curves/curve_ending.hpp"
#include "curves/curve_json.hpp"
#include "curves/curve_obj.hpp"
#include "curves/curve_svg.hpp"
#include "curves/curve_table.hpp"
#include "curves/curve_vect.hpp"
#include "text/bad_input.hpp"
#include "text/extension.hpp"
#include "text/text.hpp"

namespace tencer::io {
namespace {

struct Known {
  std::string_view extension;
  CurveFormat format;
};
constexpr std::array known{Known{".obj", CurveFormat::obj},   Known{".csv", CurveFormat::table},
                           Known{".xyz", CurveFormat::table}, Known{".txt", CurveFormat::table},
                           Known{".tsv", CurveFormat::table}, Known{".dat", CurveFormat::table},
                           Known{".pts", CurveFormat::table}, Known{".json", CurveFormat::json},
                           Known{".vect", CurveFormat::vect}, Known{".vec", CurveFormat::vect},
                           Known{".svg", CurveFormat::svg},   Known{".dxf", CurveFormat::dxf}};

// Files of other kinds that people have curves in.
struct Foreign {
  std::string_view extensions;  // between blanks
  std::string_view remedy;
};
constexpr std::array foreign{
    Foreign{" .stl .ply .off .glb .gltf .fbx .3mf ",
            "is a mesh and holds no curves; save the curve itself as OBJ or CSV"},
    Foreign{" .step .stp .igs .iges .3dm .sat .x_t .dwg .skp .blend ",
            "is of a CAD program; export the curve there as DXF or OBJ, or its points as CSV"},
    Foreign{" .geojson .gpx .kml .shp ",
            "is of a map, in degrees; project it to metres and save the points as CSV, x,y,z a "
            "line"},
    Foreign{" .vtp .vtk .vtu .vtm .pvd .cpt .pvsm ",
            "is of ParaView; there choose File, Save Data, and save the points as CSV"},
    Foreign{" .pdf .ai .eps .ps .cdr .png .jpg .jpeg ",
            "is a picture or a page; save the drawing as plain SVG"},
    Foreign{" .xlsx .xls .ods ", "is of a spreadsheet; save the sheet as CSV, x, y, z a line"}};

// The first words of a text, of lines that are no comments.
std::vector<std::string_view> first_words(std::string_view text) {
  constexpr std::size_t enough = 4;
  std::vector<std::string_view> result;
  for (const std::string_view line : lines(text.substr(0, 4096))) {
    for (const std::string_view word : words(line.substr(0, line.find('#'))))
      result.push_back(word);
    if (result.size() >= enough) break;
  }
  return result;
}

bool is_vect(std::string_view word) {
  return word == "VECT" || word == "4VECT" || word == "{VECT" || word == "appearance";
}

std::optional<CurveFormat> format_by_content(std::string_view text) {
  const auto first = first_words(text);
  if (first.empty()) return std::nullopt;
  if (is_vect(first[0]) || (first.size() > 1 && first[0] == "{" && is_vect(first[1])))
    return CurveFormat::vect;
  if (first[0].starts_with('<')) return CurveFormat::svg;
  if (first[0].starts_with('{') || first[0].starts_with('[')) return CurveFormat::json;
  if ((first[0] == "0" && first.size() > 1 && first[1] == "SECTION") || first[0] == "999")
    return CurveFormat::dxf;
  constexpr std::array<std::string_view, 7> obj_words{"v", "o", "g", "mtllib", "l", "vn", "cstype"};
  if (std::ranges::find(obj_words, first[0]) != obj_words.end()) return CurveFormat::obj;
  return std::nullopt;
}

std::string extensions() {
  std::string text;
  for (const Known& one : known)
    text += std::string(text.empty() ? "" : ", ") + std::string(one.extension);
  return text;
}

}  // namespace

std::optional<CurveFormat> format_by_extension(const std::filesystem::path& path) {
  const auto* one = std::ranges::find(known, lower_extension(path), &Known::extension);
  return one == known.end() ? std::nullopt : std::optional(one->format);
}

CurveFormat format_of(const std::filesystem::path& path, std::string_view text,
                      const std::string& file) {
  const std::string extension = lower_extension(path);
  for (const Foreign& one : foreign)
    if (!extension.empty() && one.extensions.find(" " + extension + " ") != std::string_view::npos)
      fail(file, std::string(one.remedy));
  const auto by_content = format_by_content(text);
  // A table is what any text file may hold, and names do not tell which.
  if (const auto named = format_by_extension(path))
    return *named == CurveFormat::table ? by_content.value_or(*named) : *named;
  if (by_content) return *by_content;
  if (!extension.empty() && path != "-")
    fail(file, "unknown kind of curve file '" + extension + "'; use one of " + extensions());
  return CurveFormat::table;
}

CurveFile parse_curves(const std::filesystem::path& path, std::string_view text,
                       const std::string& file) {
  switch (format_of(path, text, file)) {
    case CurveFormat::obj:
      return parse_obj(text, file);
    case CurveFormat::json:
      return parse_curve_json(text, file);
    case CurveFormat::vect:
      return parse_vect(text, file);
    case CurveFormat::svg:
      return parse_svg(text, file);
    case CurveFormat::dxf:
      return parse_dxf(text, file);
    case CurveFormat::table:
      break;
  }
  return parse_table(text, file);
}

}  // namespace tencer::io
