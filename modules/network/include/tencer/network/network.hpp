// A network: a structure with its cables and the pose in which it rests.
//
// All stages from here up work in scaled units (model/scaling.hpp): the rods' total length is 1 and
// the largest EI / length is 1. Thresholds of the search are chosen for these.
#pragma once

#include <Eigen/Core>
#include <tencer/model/state.hpp>
#include <vector>

namespace tencer::network {

struct Network {
  model::Structure structure{};
  model::State state{};  // an equilibrium of `structure` unless a StageResult says otherwise
};

int cable_count(const Network& network);

// One entry a cable, at the network's state: the length |d|, the tension k (|d| - l), and the force
// density, tension per length.
Eigen::VectorXd cable_lengths(const Network& network);
Eigen::VectorXd cable_tensions(const Network& network);
Eigen::VectorXd force_densities(const Network& network);

// The cables that do not pull: tension at most 1e-9 of the largest.
std::vector<int> idle_cables(const Network& network);

}  // namespace tencer::network
