#include "stiffness_floor.hpp"

#include <algorithm>
#include <cmath>
#include <tencer/linalg/symmetric_factor.hpp>

namespace tencer::sparsify {

bool stiffer_than(const sensitivity::Configuration& at, double limit) {
  if (limit <= 0) return at.linearisation.regular && at.linearisation.negative == 0;
  const auto& system = at.system;
  const auto& rods = system.structure().rods;
  double length = 0;
  double bending = 0;
  for (const auto& rod : rods) {
    length += rod.length();
    bending = std::max({bending, rod.section.EI1, rod.section.EI2});
  }
  const double unit = bending / std::pow(length, 4);
  linalg::SymmetricMatrix shifted = at.linearisation.matrix;  // anchored against rigid motion
  for (int r = 0; r < static_cast<int>(rods.size()); ++r) {
    const auto& lengths = rods[r].rest_lengths;
    for (int v = 0; v < rods[r].vertices(); ++v) {
      const int edges = static_cast<int>(lengths.size());
      const double before = v > 0 ? lengths[v - 1] : rods[r].closed ? lengths[edges - 1] : 0.0;
      const double after = v < edges ? lengths[v] : 0.0;
      for (int axis = 0; axis < 3; ++axis) {
        const int i = system.position_index(r, v, axis);
        if (i >= 0) shifted.coeffRef(i, i) -= limit * unit * (before + after) / 2;
      }
    }
  }
  linalg::SymmetricFactor factor;
  return factor.factorise(shifted) && factor.inertia().negative == system.saddle_unknowns();
}

}  // namespace tencer::sparsify
