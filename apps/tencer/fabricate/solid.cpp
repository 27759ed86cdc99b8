#include "fabricate/solid.hpp"

#include <tencer/geometry/sampling.hpp>
#include <tencer/model/units.hpp>

namespace tencer::app {

Solid solid_of(const model::Design& design) {
  const model::Structure& structure = design.structure;
  const double mm = 1000 * model::metres(design.length_unit);
  const auto along = model::arc_lengths(structure);
  Solid solid{.rods = static_cast<int>(structure.rods.size()), .anchors = structure.anchors * mm};
  for (std::size_t r = 0; r < structure.rods.size(); ++r) {
    solid.curves.push_back(model::pose_curve(design, r));
    solid.curves.back().points *= mm;
  }
  for (const springs::Cable& cable : structure.cables) {
    geometry::Polyline line{Eigen::Matrix3Xd(3, 2), false};
    std::vector<int> on_rods;
    for (const int end : {0, 1}) {
      const springs::End& at = end == 0 ? cable.a : cable.b;
      if (const auto* on = std::get_if<springs::OnRod>(&at)) {
        line.points.col(end) = geometry::point_at(solid.curves[on->rod], along[on->rod], on->s);
        on_rods.push_back(on->rod);
      } else {
        line.points.col(end) = solid.anchors.col(std::get<springs::AtAnchor>(at).anchor);
      }
    }
    solid.curves.push_back(line);
    solid.ends_on.push_back(on_rods);
  }
  return solid;
}

Eigen::Matrix3Xd points_of(const Solid& solid) {
  Eigen::Index count = solid.anchors.cols();
  for (int r = 0; r < solid.rods; ++r) count += solid.curves[r].points.cols();
  Eigen::Matrix3Xd points(3, count);
  Eigen::Index at = 0;
  for (int r = 0; r < solid.rods; ++r) {
    const Eigen::Matrix3Xd& own = solid.curves[r].points;
    points.middleCols(at, own.cols()) = own;
    at += own.cols();
  }
  points.rightCols(solid.anchors.cols()) = solid.anchors;
  return points;
}

}  // namespace tencer::app
