// Lines in space as DXF of release 12, which every program reads and which needs neither handles
// nor a dictionary, so that no library is needed to write it.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <tencer/geometry/polyline.hpp>

namespace tencer::io {

struct DxfLine {
  std::string layer{};        // capitals, digits and _
  int colour = 7;             // of AutoCAD's index
  geometry::Polyline line{};  // one point: a POINT
};

// unit: of curve_units(), or "" for none.
std::string dxf_text(std::span<const DxfLine> lines, std::string_view unit);

}  // namespace tencer::io
