// The dense network that the paper's route starts from (paper section 5.1).
#pragma once

#include <tencer/model/state.hpp>
#include <vector>

namespace tencer::ground_structure {

// `candidates` as springs that hold the rods at `positions` (3 x n per rod): rest lengths are the
// distances there, stiffness is factor * E c^2 / L (section 5.2; the paper's factor is 100), E
// Young's modulus, c the section's thickness (diameter) and L the rod's length; the softer of the
// two rods counts. E c^2 = 4 EA / pi for a solid circle; that is the value taken for every section.
// Any units. Throws std::invalid_argument when sizes do not fit.
std::vector<springs::Cable> dense_springs(const model::Structure& structure,
                                          const std::vector<Eigen::Matrix3Xd>& positions,
                                          std::vector<springs::Cable> candidates,
                                          double factor = 100);

}  // namespace tencer::ground_structure
