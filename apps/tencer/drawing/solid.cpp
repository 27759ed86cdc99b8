#include "drawing/solid.hpp"

#include <tencer/geometry/smooth.hpp>
#include <tencer/model/cable_lines.hpp>
#include <tencer/model/units.hpp>

namespace tencer::app {

geometry::Polyline smooth(const geometry::Polyline& curve) {
  constexpr int enough = 300;  // edges
  return geometry::smoothed(curve, (enough + curve.edges() - 1) / curve.edges());
}

Solid solid_of(const model::Design& design) {
  const model::Structure& structure = design.structure;
  const double mm = 1000 * model::metres(design.length_unit);
  Solid solid{.rods = static_cast<int>(structure.rods.size()),
              .anchors = structure.anchors * mm,
              .views = design.views};
  for (std::size_t r = 0; r < structure.rods.size(); ++r) {
    solid.curves.push_back(smooth(model::pose_curve(design, r)));
    solid.curves.back().points *= mm;
  }
  for (geometry::Polyline& line : model::cable_lines(design)) {
    line.points *= mm;
    solid.curves.push_back(std::move(line));
  }
  for (const springs::Cable& cable : structure.cables) {
    std::vector<int>& on_rods = solid.ends_on.emplace_back();
    for (const springs::End& end : {cable.a, cable.b})
      if (const auto* on = std::get_if<springs::OnRod>(&end)) on_rods.push_back(on->rod);
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
