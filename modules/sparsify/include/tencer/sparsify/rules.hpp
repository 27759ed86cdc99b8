// Which cables a design may have.
#pragma once

#include <limits>
#include <optional>
#include <tencer/core/error.hpp>
#include <tencer/equilibrium/structure.hpp>
#include <vector>

namespace tencer::sparsify {

struct RodPair {
  int a = 0;
  int b = 0;  // may be the same rod
};

// Arc lengths at rest, ends included. On a closed rod an arc with to < from runs across the seam.
struct Arc {
  int rod = 0;
  double from = 0.0;
  double to = 0.0;
};

struct Rules {
  std::optional<std::vector<RodPair>> pairs{};  // rods that cables may join; not set: any
  std::vector<Arc> forbidden{};                 // where no cable may attach
  double longest =
      std::numeric_limits<double>::infinity();  // of a cable; candidates stay 1 % below
  bool external = true;                         // cables to anchors, when the structure has any
};

// Throws std::invalid_argument, naming the field, unless rods exist, arcs lie on their rod and
// `longest` is positive.
void validate(const Rules& rules, const equilibrium::Structure& structure);

// Whether cables may join two rods.
bool pair_allowed(const Rules& rules, int rod_a, int rod_b);

// Whether a cable may attach at arc length s of a rod (any s on a closed rod).
bool place_allowed(const Rules& rules, const equilibrium::Structure& structure, int rod, double s);

struct Interval {
  double lower = 0.0;
  double upper = 0.0;
};

// How far a cable end may slide from an allowed place s without leaving its rod or entering a
// forbidden arc; the bounds are allowed places. On a closed rod without forbidden arcs: one length
// of the rod either way.
Interval sliding_interval(const Rules& rules, const equilibrium::Structure& structure, int rod,
                          double s);

// All cables between vertices of the rods, and from vertices to anchors, that the rules allow at
// `positions` (3 x n per rod), with stiffness and rest length 0 (paper section 5.1). Left out as
// useless: cables between neighbours on a rod, and between vertices that supports hold.
//
// Errors: no cable is allowed; two vertices, or a vertex and an anchor, that an allowed cable would
// join coincide, say because a rod crosses itself.
core::Expected<std::vector<springs::Cable>> candidates(
    const equilibrium::Structure& structure, const std::vector<Eigen::Matrix3Xd>& positions,
    const Rules& rules);

}  // namespace tencer::sparsify
