// How a structure gives way under its own weight.
#pragma once

#include <Eigen/Core>
#include <stop_token>
#include <tencer/certify/stance.hpp>
#include <tencer/model/state.hpp>
#include <vector>

namespace tencer::certify {

// The largest distance of a vertex from the pose without weight, aligned as there: to first order
// up to 1 % of the size (the pose's bounding-box diagonal), else where it comes to rest as its
// weight grows from nothing.
struct Sag {
  double deviation = 0.0;
  // The vertices that it hangs from or stands on; none: its own supports.
  std::vector<Support> at{};
  bool settled = false;   // not to first order
  bool falls = false;     // to another pose, before all its weight is on it
  bool computed = false;  // false: the pose is singular, or supports leave it free to swing
};

// A structure that nothing holds hangs from one of its vertices, turned so that its middle is
// below: of `tries` vertices spread evenly along every rod from that by which it sags least. One
// that is held stays as it is, and its weight pulls along -z (-y of a planar one). tensions: per
// cable, as the equilibrium has them; weight_per_length: per rod, force per length at rest.
Sag own_weight_sag(const model::Structure& structure, const model::State& state,
                   const Eigen::VectorXd& tensions, const Eigen::VectorXd& weight_per_length,
                   int tries = 24, const std::stop_token& stop = {});

// Of a structure that stands, on feet that do not slide. What else of it may touch the ground does
// not count.
Sag standing_sag(const model::Structure& structure, const model::State& state,
                 const Eigen::VectorXd& tensions, const Eigen::VectorXd& weight_per_length,
                 const Stance& stance, const std::stop_token& stop = {});

}  // namespace tencer::certify
