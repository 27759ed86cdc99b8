// The dense network every design starts from (paper section 5.1).
#pragma once

#include <tencer/equilibrium/structure.hpp>
#include <vector>

namespace tencer::sparsify {

// `candidates` as springs that hold the rods at `positions` (3 x n per rod): rest lengths are the
// distances there, stiffness is 100 E c^2 / L (section 5.2), E Young's modulus, c the section's
// thickness (diameter) and L the rod's length; the softer of the two rods counts. E c^2 = 4 EA / pi
// for a solid circle; that is the value taken for every section.
std::vector<springs::Cable> dense_springs(const equilibrium::Structure& structure,
                                          const std::vector<Eigen::Matrix3Xd>& positions,
                                          std::vector<springs::Cable> candidates);

}  // namespace tencer::sparsify
