// How a structure gives way under its own weight.
#pragma once

#include <Eigen/Core>
#include <tencer/model/state.hpp>

namespace tencer::certify {

// The largest distance of a vertex from the pose without weight, aligned as there, to first order.
struct Sag {
  double deviation = 0.0;
  int rod = -1;  // the vertex that it hangs from, by which it sags least; -1: it is held as it is
  int vertex = -1;
  bool computed = false;  // false: the pose is singular, or supports leave it free to swing
};

// A structure that nothing holds hangs from one of its vertices, turned so that its middle is
// below; of `tries` vertices spread evenly along every rod the best is taken. One that is held
// stays as it is, and its weight pulls along -z (-y of a planar one). tensions: per cable, as the
// equilibrium has them; weight_per_length: per rod, force per length at rest.
Sag own_weight_sag(const model::Structure& structure, const model::State& state,
                   const Eigen::VectorXd& tensions, const Eigen::VectorXd& weight_per_length,
                   int tries = 24);

}  // namespace tencer::certify
