// The planar shapes of a discrete rod whose ends are pressed together, by shooting in extended
// precision: the known answer of most rows.
#pragma once

#include <Eigen/Core>
#include <numbers>
#include <tencer/der/rod.hpp>

namespace tencer::app::stress {

// The angle that most bows have at their ends.
inline constexpr double thirty_degrees = std::numbers::pi / 6;

struct Bow {
  Eigen::Matrix3Xd x;  // from (0, 0, 0) to (span, 0, 0), bowed towards y
  double load = 0.0;   // the force on each end, inwards
  double span = 0.0;   // distance between the ends
};

// The rod, open, straight at rest and isotropic, with hinged ends, its first edge at `angle`
// (radians, 0 to pi / 2) to the line between them. Solves the stationarity of the rod's discrete
// energy itself (stretching and bending, see der/energy.hpp), not of the continuum: along the rod
// the force is constant and the moment M_i = 4 EI / v y (1 + y^2), y = tan(turning angle / 2),
// falls by load times the rise of each edge.
Bow bow(const der::Rod& rod, double angle);

}  // namespace tencer::app::stress
