// An equilibrium written into a design.
#pragma once

#include <tencer/model/design.hpp>
#include <tencer/model/scaling.hpp>
#include <tencer/model/state.hpp>
#include <tencer/model/target.hpp>

namespace tencer::pipeline {

// A state of a scaled structure with its cables: tensions, one a cable; target, scaled.
struct Solved {
  const model::Structure& structure;
  const model::State& state;
  const Eigen::VectorXd& tensions;
  const model::Target& target;
};

// Sets poses and their directors (moved onto the target when that is aligned), lengths and tensions
// of the cables, error and certificate. The design has the structure's cables in the same order.
void record(const Solved& solved, const model::Scaling& scaling, model::Design& design);

}  // namespace tencer::pipeline
