// How the outer optimizers are used, the same in every stage that has one.
#pragma once

#include <tencer/optimize/backend.hpp>

namespace tencer::sparsify {

// What a backend that uses second derivatives is given; others ignore it.
enum class SecondDerivatives {
  none,          // it estimates them from gradients; gauss-newton, which cannot, takes its own
  gauss_newton,  // of the distance to the target
  exact
};

struct OuterOptions {
  SecondDerivatives second_derivatives = SecondDerivatives::gauss_newton;
  // An optimization is done in rounds, each from where the last one ended: rest lengths are set
  // anew in between, and rounds end when one gains less than `least_gain` of the objective.
  int rounds = 12;
  int iterations = 40;           // of the optimizer in a round, with second derivatives
  int iterations_without = 150;  // and without
  double least_gain = 0.01;
  // See optimize::Options; the objective is of order one at the tolerance asked for.
  double gradient_tolerance = 1e-4;
  double value_tolerance = 1e-5;
  // Of the smallest eigenvalue when rest lengths are set, see RestLengthOptions::margin.
  double stability_margin = 0.3;
  // States with a smaller eigenvalue (in the units of equilibrium::Stability) are not entered:
  // designs that fit ever better by getting ever softer would not survive being built. A free
  // straight rod has 500. Networks that are softer at the start are held to half of what they have.
  double least_eigenvalue = 500.0;
};

}  // namespace tencer::sparsify
