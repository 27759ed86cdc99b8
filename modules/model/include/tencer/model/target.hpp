// The shape that a structure is meant to take.
#pragma once

#include <Eigen/Core>
#include <tencer/model/structure.hpp>
#include <tencer/model/view.hpp>
#include <vector>

namespace tencer::model {

struct Target {
  std::vector<Eigen::Matrix3Xd> points{};  // per rod, 3 x n: where its vertices should be
  // Per rod, per vertex, >= 0, not all zero; vertices of weight 0 may be anywhere. Empty: all 1.
  std::vector<Eigen::VectorXd> weights{};
  // Move the target rigidly onto the shape before measuring; not for structures that anchors or
  // pins hold in place. All rods move together.
  bool align = true;
  bool planar = false;  // then only within the plane z = const
  // From where distances to the target are seen; not of a planar target. Empty: distances in space.
  std::vector<View> views{};
};

// The target `points` of a structure with its cables: aligned unless pins or cables to anchors hold
// the structure in space. weights: as Target has them.
Target make_target(const Structure& structure, std::vector<Eigen::Matrix3Xd> points,
                   std::vector<Eigen::VectorXd> weights = {});

// Throws std::invalid_argument unless the target's sizes and weights fit the structure, and its
// views are sound.
void validate(const Target& target, const Structure& structure);

// The weights of a rod's vertices, also where the target does not give any.
Eigen::VectorXd weights_of(const Target& target, std::size_t rod);

// The diagonal of the axis-aligned box about all points: the size in percent of which distances are
// told.
double diagonal(const Target& target);

}  // namespace tencer::model
