#include "drawing/picture.hpp"

#include <algorithm>
#include <cctype>
#include <set>
#include <string_view>
#include <tencer/core/error.hpp>
#include <tencer/core/words.hpp>
#include <tencer/model/units.hpp>

#include "drawing/layout.hpp"

namespace tencer::app {
namespace {

using Eigen::Vector2d;

// Colours stand in Cairo's SVG as they are printed; those of paper and ink follow the reader's
// scheme.
constexpr std::string_view reader_styles =
    R"css(<style>@media (prefers-color-scheme: dark) {
[style*="fill:rgb(100%,100%,100%)"] { fill: #11161c !important }
[style*="stroke:rgb(100%,100%,100%)"] { stroke: #11161c !important }
[style*="fill:rgb(11%,14%,17%)"] { fill: #e6e9ec !important }
[style*="stroke:rgb(11%,14%,17%)"] { stroke: #e6e9ec !important }
}</style>)css";

// Those of a frame that no cable goes to only make the structure small.
Eigen::Matrix3Xd anchors_in_use(const model::Design& design) {
  std::set<int> used;
  for (const springs::Cable& cable : design.structure.cables)
    for (const springs::End& end : {cable.a, cable.b})
      if (const auto* at = std::get_if<springs::AtAnchor>(&end)) used.insert(at->anchor);
  Eigen::Matrix3Xd anchors(3, static_cast<Eigen::Index>(used.size()));
  Eigen::Index column = 0;
  for (const int anchor : used) anchors.col(column++) = design.structure.anchors.col(anchor);
  return anchors;
}

}  // namespace

std::optional<PictureFormat> picture_format(const std::filesystem::path& path) {
  std::string ending = path.extension().string();
  std::ranges::transform(ending, ending.begin(),
                         [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  if (ending == ".svg") return PictureFormat::svg;
  if (ending == ".pdf") return PictureFormat::pdf;
  if (ending == ".png") return PictureFormat::png;
  return std::nullopt;
}

std::optional<core::Error> picture_problem(const std::filesystem::path& path) {
  if (picture_format(path)) return std::nullopt;
  return core::Error{path.string(),
                     "there are no pictures with this ending; let the name end with .svg, .pdf or "
                     ".png"};
}

std::string picture(const model::Design& design, PictureFormat format,
                    const PictureOptions& options) {
  constexpr double dots_per_inch = 300;
  core::require(!design.structure.rods.empty(), "picture: needs at least one rod");
  const auto cables = static_cast<int>(design.structure.cables.size());
  Solid solid = solid_of(design);
  solid.anchors = anchors_in_use(design) * 1000 * model::metres(design.length_unit);
  const Layout layout(solid, options);
  const Vector2d size = layout.size();
  const auto draw_all = [&](Canvas& canvas) { layout.draw_all(canvas, layout.look()); };
  if (format == PictureFormat::pdf) return pdf_drawing(size.x(), size.y(), design.name, draw_all);
  if (format == PictureFormat::png) return png_drawing(size.x(), size.y(), dots_per_inch, draw_all);
  return svg_drawing(size.x(), size.y(), "Rods held in shape by " + core::counted(cables, "cable"),
                     draw_all);
}

std::string picture_svg(const model::Design& design) {
  const std::string svg = picture(design, PictureFormat::svg);
  const std::size_t start = svg.find("<svg");
  return svg.substr(start).insert(svg.find('>', start) + 1 - start, reader_styles);
}

}  // namespace tencer::app
