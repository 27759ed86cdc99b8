// Pins replaced by cables: a vertex that was held in space is then held by cables to anchors that
// pull as the pin did (paper section 6.1, figure 13).
#pragma once

#include <Eigen/Core>
#include <limits>
#include <tencer/ground_structure/problem.hpp>
#include <tencer/network/stage.hpp>
#include <vector>

namespace tencer::ground_structure {

// The force with which each of structure.pins holds its vertex (3 x pins). state: an equilibrium.
Eigen::Matrix3Xd pin_forces(const model::Structure& structure, const model::State& state);

// tensions[i] > 0 towards anchors[i]; both are empty for no force.
struct AnchorPull {
  std::vector<int> anchors{};
  Eigen::VectorXd tensions{};
};

// Three anchors (in the plane two) whose pulls at `point` sum to `force`: those that can take the
// largest change of the force, in any direction, before one of their cables is slack, for the sum
// of their tensions. Fewer where the force points at an anchor or a line between two. Anchors
// further than `max_length` do not count; throws std::invalid_argument unless the others surround
// the point.
AnchorPull anchor_pull(const Eigen::Vector3d& point, const Eigen::Vector3d& force,
                       const Eigen::Matrix3Xd& anchors, bool planar = false,
                       double max_length = std::numeric_limits<double>::infinity());

// The network, of problem.structure with cables, without pins: each of them is replaced by the
// cables of anchor_pull(), as good as inextensible. It is the same equilibrium, solved for again. A
// pin that does not pull is just taken away. With a symmetry in the problem the cables are the same
// at pins that it maps onto each other.
network::StageResult replace_pins(const network::Network& pinned, const Problem& problem,
                                  const network::Control& control = {});

}  // namespace tencer::ground_structure
