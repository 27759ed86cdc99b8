#include "export/parts.hpp"

#include <tencer/core/names.hpp>
#include <tencer/model/cable_lines.hpp>

namespace tencer::io {

std::vector<Part> parts_of(const model::Design& design) {
  std::vector<Part> parts;
  for (std::size_t r = 0; r < design.structure.rods.size(); ++r) {
    const int rod = static_cast<int>(r);
    parts.push_back(
        {PartKind::rod, rod, "rod " + core::rod_name(rod), model::pose_curve(design, r)});
  }
  int cable = 0;
  for (geometry::Polyline& line : model::cable_lines(design)) {
    parts.push_back({PartKind::cable, cable, core::cable_in_words(cable), std::move(line)});
    ++cable;
  }
  for (int a = 0; a < design.structure.anchors.cols(); ++a)
    parts.push_back(
        {PartKind::anchor, a, core::anchor_name(a), {design.structure.anchors.col(a), false}});
  return parts;
}

}  // namespace tencer::io
