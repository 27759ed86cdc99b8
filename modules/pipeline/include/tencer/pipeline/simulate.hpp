// The equilibrium of a design file: where the structure settles.
#pragma once

#include <stop_token>
#include <string>
#include <tencer/core/error.hpp>
#include <tencer/equilibrium/solve.hpp>
#include <tencer/io/design.hpp>
#include <tencer/pipeline/convert.hpp>

namespace tencer::pipeline {

enum class Start { target, pose };

struct SimulateOptions {
  Start start = Start::pose;
  Cables cables = Cables::inextensible;
  int refine = 1;  // edges into which every edge is divided first, see refined()
  equilibrium::SolveOptions solve{};
};

struct Simulation {
  // The input, refined as asked, with the pose, tensions, error and certificate found; its status
  // tells when the state is not usable.
  io::Design design{};
  equilibrium::Reason reason = equilibrium::Reason::iteration_limit;
  int unknowns = 0;
  int iterations = 0;
  int factorisations = 0;
  double seconds = 0.0;
  double residual = 0.0;
  // Largest distance of the input's vertices to where they were in its pose, in % of the target's
  // bounding-box diagonal, rigidly aligned unless the structure is held in place.
  double moved_percent = 0.0;

  bool usable() const {
    return reason == equilibrium::Reason::converged || reason == equilibrium::Reason::rounding;
  }
};

// Errors name the cable: springs are asked for and it has no stiffness, or its ends are the same
// point at the start.
core::Expected<Simulation> simulate(const io::Design& design, const SimulateOptions& options = {});

}  // namespace tencer::pipeline
