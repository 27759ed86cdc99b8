#include <tencer/geometry/sampling.hpp>
#include <tencer/model/cable_lines.hpp>

namespace tencer::model {

std::vector<geometry::Polyline> cable_lines(const Design& design) {
  const Structure& structure = design.structure;
  const auto along = arc_lengths(structure);
  const auto point = [&](const springs::End& end) -> Eigen::Vector3d {
    if (const auto* on = std::get_if<springs::OnRod>(&end))
      return geometry::point_at(pose_curve(design, on->rod), along[on->rod], on->s);
    return structure.anchors.col(std::get<springs::AtAnchor>(end).anchor);
  };
  std::vector<geometry::Polyline> lines;
  for (const springs::Cable& cable : structure.cables) {
    geometry::Polyline line{Eigen::Matrix3Xd(3, 2), false};
    line.points << point(cable.a), point(cable.b);
    lines.push_back(line);
  }
  return lines;
}

}  // namespace tencer::model
