// Where a designed structure comes to rest.
#pragma once

#include <optional>
#include <tencer/core/error.hpp>
#include <tencer/equilibrium/solve.hpp>
#include <tencer/model/design.hpp>

namespace tencer::pipeline {

enum class Start { target, pose };

// How the cables of a design are taken. Springs need a stiffness and a rest length.
enum class Cables { springs, inextensible };

struct SimulateOptions {
  Start start = Start::pose;
  Cables cables = Cables::inextensible;
  int refine = 1;  // edges into which every edge is divided first, see model::subdivided
  equilibrium::SolveOptions solve{};

  // Throws std::invalid_argument, naming the field, unless refine >= 1.
  void validate() const;
};

struct [[nodiscard]] Simulation {
  // The input, refined as asked, with the pose, tensions, error and certificate found; its status
  // tells when it does not stay.
  model::Design design{};
  equilibrium::Reason reason = equilibrium::Reason::iteration_limit;
  int unknowns = 0;
  int iterations = 0;
  int factorisations = 0;
  double seconds = 0.0;
  double residual = 0.0;
  // Largest distance of the input's vertices to where they were in its pose, in % of the target's
  // bounding-box diagonal, rigidly aligned unless the structure is held in place; as the design's
  // views see it.
  double moved_percent = 0.0;
  // From the pose with inextensible cables: after which part of the way from the pose's lengths and
  // forces to the design's the structure jumps, see equilibrium::PathEquilibrium.
  std::optional<double> fold_at = std::nullopt;

  bool usable() const {
    return reason == equilibrium::Reason::converged || reason == equilibrium::Reason::rounding;
  }
  // Whether it comes to rest, and within 1 % of the target's size from the input's pose.
  bool stays() const { return usable() && moved_percent <= 1; }
};

// Errors name the cable: springs are asked for and it has no stiffness, or its ends are the same
// point at the start.
core::Expected<Simulation> simulate(const model::Design& design,
                                    const SimulateOptions& options = {});

}  // namespace tencer::pipeline
