// How the outer optimizers are used, the same in every stage of the paper's route that has one.
#pragma once

#include <tencer/model/settings.hpp>
#include <tencer/optimize/backend.hpp>

namespace tencer::sparsify {

struct OuterOptions {
  // What a backend that uses second derivatives is given; others ignore it. gauss-newton, which
  // cannot do without, takes Gauss-Newton matrices for limited_memory.
  model::SecondDerivatives second_derivatives = model::SecondDerivatives::gauss_newton;
  // An optimization is done in rounds, each from where the last one ended: rest lengths are set
  // anew in between, and rounds end when one gains less than `min_gain` of the objective.
  int rounds = 12;
  int iterations = 40;           // of the optimizer in a round, with second derivatives
  int iterations_without = 150;  // and without
  double min_gain = 0.01;
  // See optimize::Options; the objective is of order one at the tolerance asked for.
  double gradient_tolerance = 1e-4;
  double value_tolerance = 1e-5;
  // See network::RestLengthOptions::margin.
  double stability_margin = 0.3;
  // States with a smaller eigenvalue (in the units of equilibrium::Stability) are not entered:
  // designs that fit ever better by getting ever softer would not survive being built. A free
  // straight rod has 500. Networks that are softer at the start are held to half of what they have.
  double min_eigenvalue = 500.0;

  // Throws std::invalid_argument, naming the field, unless the numbers make sense.
  void validate() const;
};

}  // namespace tencer::sparsify
