// What is claimed about a design as it is built, with cables that can neither stretch nor push.
#pragma once

#include <optional>

namespace tencer::model {

// The unit in which eigenvalues are told.
inline constexpr const char* eigenvalue_unit = "max EI / L^4, one unit of mass per length";

struct Certificate {
  double residual = 0.0;  // imbalance of forces, relative to the rods' internal force
  // The smallest eigenvalue of the Hessian of the Lagrangian on the motions that keep the lengths
  // of taut cables and are not rigid, in eigenvalue_unit.
  double smallest_eigenvalue = 0.0;
  int slack_cables = 0;
  // Components of rods that are free to move against each other at no cost; 0 when there are none.
  // Not in design files.
  int floating_components = 0;
  bool stable = false;  // forces balance, no cable is slack, and every motion costs energy
  // How far the vertex that moves most is off when cables are cut to 1 mm and tied to 2 mm (errors
  // independent and uniform up to these): its root mean square to first order, a length. Not set:
  // there are no cables, the pose is no stable equilibrium, or the unit of length is not known.
  std::optional<double> off_by_errors = std::nullopt;
  // Whether the design, let go at the target, comes to rest in its pose; not set: not tried.
  std::optional<bool> settles_from_target = std::nullopt;
};

}  // namespace tencer::model
