// A closed curve that is not knotted and far from round.
#pragma once

#include <cmath>
#include <numbers>
#include <tencer/geometry/polyline.hpp>

namespace tencer::curves::test {

inline geometry::Polyline unknot(int n) {
  geometry::Polyline curve{Eigen::Matrix3Xd(3, n), true};
  for (int i = 0; i < n; ++i) {
    const double t = 2 * std::numbers::pi * i / n;
    curve.points.col(i) << std::cos(t) + 0.5 * std::cos(2 * t), std::sin(t), 0.4 * std::sin(3 * t);
  }
  return curve;
}

}  // namespace tencer::curves::test
