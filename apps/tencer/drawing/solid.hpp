// A structure as it stands, in mm, for drawings of it.
#pragma once

#include <Eigen/Core>
#include <tencer/geometry/polyline.hpp>
#include <tencer/model/design.hpp>
#include <vector>

namespace tencer::app {

struct Solid {
  // The rods, smooth, then the cables, each of two points.
  std::vector<geometry::Polyline> curves{};
  int rods = 0;
  std::vector<std::vector<int>> ends_on{};  // of every cable: the rods that it ends on
  Eigen::Matrix3Xd anchors = Eigen::Matrix3Xd(3, 0);
  std::vector<model::View> views{};  // from where it has to look right

  int cables() const { return static_cast<int>(curves.size()) - rods; }
  const geometry::Polyline& cable(int c) const { return curves[rods + c]; }
};

// With so many points that nobody sees its edges.
geometry::Polyline smooth(const geometry::Polyline& curve);

Solid solid_of(const model::Design& design);

// Of rods and anchors (3 x n).
Eigen::Matrix3Xd points_of(const Solid& solid);

}  // namespace tencer::app
