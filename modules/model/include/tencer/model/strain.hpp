// How far bends strain rods: the outer fibres of their sections at a pose.
#pragma once

#include <optional>
#include <tencer/model/state.hpp>
#include <tencer/model/structure.hpp>
#include <vector>

namespace tencer::model {

// The largest bending strain of a rod: a fraction, at a vertex and its arc length at rest.
struct BendingStrain {
  double strain = 0.0;
  double curvature = 0.0;  // there, beyond that at rest, 1 / length
  int vertex = 0;
  double s = 0.0;
};

// One entry a rod; not set where the section has no shape. A rod without bending vertices has no
// strain.
std::vector<std::optional<BendingStrain>> largest_bending_strains(const Structure& structure,
                                                                  const State& state);

}  // namespace tencer::model
