// Whether strands of rods pass through each other on the way from one place to another.
#pragma once

#include <Eigen/Core>
#include <tencer/model/structure.hpp>
#include <vector>

namespace tencer::certify {

// Whether two edges that share no vertex come nearer than they move against each other in a step,
// on the straight way from one place to the other in equal steps: one may have passed through the
// other. from, to: per rod, 3 x n, where the vertices are.
bool strands_meet(const model::Structure& structure, const std::vector<Eigen::Matrix3Xd>& from,
                  const std::vector<Eigen::Matrix3Xd>& to);

}  // namespace tencer::certify
