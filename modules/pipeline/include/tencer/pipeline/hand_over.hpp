// Pins handed over to cables: a vertex that was held in space is then held by cables to anchors
// that pull as the pin did (paper section 6.1, figure 13).
#pragma once

#include <Eigen/Core>
#include <limits>
#include <tencer/sensitivity/target.hpp>
#include <tencer/sparsify/network.hpp>
#include <tencer/symmetry/group.hpp>
#include <vector>

namespace tencer::pipeline {

// The force with which each of structure.pins holds its vertex (3 x pins). state: an equilibrium.
Eigen::Matrix3Xd reactions(const equilibrium::Structure& structure,
                           const equilibrium::State& state);

// tensions[i] > 0 towards anchors[i]; both are empty for no force.
struct Hold {
  std::vector<int> anchors{};
  Eigen::VectorXd tensions{};
};

// Three anchors (in the plane two) whose pulls at `point` sum to `force`: those that can take the
// largest change of the force, in any direction, before one of their cables is slack, for the sum
// of their tensions. Fewer where the force points at an anchor or a line between two. Anchors
// further than `longest` do not count; the others must surround the point.
Hold hold(const Eigen::Vector3d& point, const Eigen::Vector3d& force,
          const Eigen::Matrix3Xd& anchors, bool planar = false,
          double longest = std::numeric_limits<double>::infinity());

// The network without pins, each of them replaced by the cables of hold(), as good as inextensible:
// the same equilibrium, solved for again. A pin that does not pull is just taken away. symmetry:
// null, or a group of structure, pins and state; the cables are then the same at pins that it maps
// onto each other. Requires an equilibrium.
sparsify::StageResult hand_over(const sparsify::Network& pinned, const sensitivity::Target& target,
                                const symmetry::Group* symmetry = nullptr,
                                double longest = std::numeric_limits<double>::infinity(),
                                const sparsify::Control& control = {});

}  // namespace tencer::pipeline
