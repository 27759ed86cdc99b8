// Which rods are next to each other: among many, cables between others only make the search longer.
#pragma once

#include <Eigen/Core>
#include <set>
#include <span>
#include <tencer/springs/cable.hpp>
#include <utility>
#include <vector>

namespace tencer::ground_structure {

// Pairs a < b of point sets (3 x n each) of which no third one is nearer to both than they are to
// each other: the relative neighbourhood graph (Toussaint 1980), by smallest distances. It joins
// all of them.
std::set<std::pair<int, int>> relative_neighbours(const std::vector<Eigen::Matrix3Xd>& points);

// The cables without those between rods that are no neighbours.
std::vector<springs::Cable> among_neighbours(std::span<const springs::Cable> cables,
                                             const std::vector<Eigen::Matrix3Xd>& points);

}  // namespace tencer::ground_structure
