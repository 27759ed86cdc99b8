// Smooth curves for the tests of this module; the families of curves lie above it.
#pragma once

#include <cmath>
#include <numbers>
#include <tencer/geometry/sampling.hpp>

namespace tencer::geometry::test {

inline Polyline ellipse(double semi_x, double semi_y, int vertices) {
  return sample(
      [=](double t) { return Eigen::Vector3d(semi_x * std::cos(t), semi_y * std::sin(t), 0); }, 0,
      2 * std::numbers::pi, vertices, true);
}

// Open, about the z axis.
inline Polyline helix(double diameter, double pitch, double turns, int vertices) {
  return sample(
      [=](double turn) {
        const double angle = 2 * std::numbers::pi * turn;
        return Eigen::Vector3d(diameter / 2 * std::cos(angle), diameter / 2 * std::sin(angle),
                               pitch * turn);
      },
      0, turns, vertices, false);
}

}  // namespace tencer::geometry::test
