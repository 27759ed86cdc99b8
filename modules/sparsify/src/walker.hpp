// A network in equilibrium that is changed step by step; steps that lead astray are not taken.
#pragma once

#include <span>
#include <tencer/linalg/symmetric_factor.hpp>
#include <tencer/sensitivity/target.hpp>
#include <tencer/sensitivity/tracker.hpp>
#include <tencer/sparsify/network.hpp>
#include <tencer/sparsify/rules.hpp>

#include "planner.hpp"
#include "soft_modes.hpp"

namespace tencer::sparsify {

// Rest length relative to length of cables that are as good as inextensible: they hold what
// Newton's method would otherwise chase.
inline constexpr double taut = 0.999;

// What networks are made for; refers to the caller's objects.
struct Task {
  const sensitivity::Target& target;
  const Rules& rules;
  const symmetry::Group* symmetry = nullptr;  // null: none
  double least_eigenvalue = 0.0;              // softer networks are not entered
  int groups = 1;                             // of rods, free of each other, at most
  int kept = 0;  // the first cables stay as they are; only without symmetry
};

// The objective is the mismatch of `aim` plus softness * sum of (10 least_eigenvalue / eigenvalue)
// over the softest modes: networks are kept clear of the loss of stability.
struct Drive {
  Aim aim{};
  double softness = 0.0;
};

class Walker {
 public:
  Walker(const Network& network, const Task& task, const Drive& drive, const Control& control);

  // From another network, with the same rods; false when it is not in stable equilibrium, then the
  // walker stays unusable until the next restart that is.
  bool restart(const Network& network);
  bool usable() const { return usable_; }
  void set(const Drive& drive);

  int cables() const { return static_cast<int>(at_.cables().size()); }
  double value() const { return value_; }
  double softest() const { return soft_.values[0]; }
  const sensitivity::Deviation& deviation() const { return deviation_; }
  const sensitivity::Configuration& at() const { return at_; }
  Network network() const { return {at_.system.structure(), at_.state}; }

  // care: factor on the damping.
  Planner planner(double care = 1.0) const;

  // Per orbit, what the objective grows by when its first cable no longer resists stretching, all
  // else held: infinite when the network would not be stable.
  Eigen::VectorXd removal_softness(const LocalModel& model) const;

  // Takes a step of the model's variables, without the orbits `out`, to an equilibrium whose
  // objective is below `accepted`; false: stays.
  bool move(const LocalModel& model, const Eigen::VectorXd& step, const std::vector<int>& out,
            double accepted);

  // At most so many damped Gauss-Newton steps, until one gains less than this part.
  void refit(int steps, double least_gain = 0.02);

  int solves() const { return solves_; }
  int iterations() const { return iterations_; }
  bool stopped() const { return control_.stop.stop_requested(); }

 private:
  bool settle(equilibrium::State start, const SoftModes& nearby,
              const equilibrium::SolveOptions& options);
  void accept();
  double objective(const Eigen::VectorXd& residual, const SoftModes& soft) const;
  Squares softness_terms(const LocalModel& model) const;
  StepBounds step_bounds(const LocalModel& model) const;

  Task task_;
  Drive drive_;
  Control control_;
  sensitivity::Configuration at_, trial_;
  SoftModes soft_, trial_soft_;
  sensitivity::Deviation deviation_, trial_deviation_;
  double value_ = 0.0, trial_value_ = 0.0;
  double damping_ = 1e-2;
  linalg::SymmetricFactor workspace_;
  bool usable_ = false;
  int solves_ = 0, iterations_ = 0;
};

}  // namespace tencer::sparsify
