// A network in equilibrium that is changed step by step; a step is taken only when its equilibrium
// is stable, near, and better.
#pragma once

#include <limits>
#include <optional>
#include <tencer/elimination/options.hpp>
#include <tencer/equilibrium/modal.hpp>
#include <tencer/model/rules.hpp>
#include <tencer/network/stage.hpp>
#include <tencer/network/stage_recorder.hpp>
#include <tencer/sensitivity/tracker.hpp>

#include "model/error_response.hpp"
#include "model/gauss_newton_model.hpp"

namespace tencer::elimination {

// What networks are made for, and what they must keep. Refers to the caller's objects.
struct Requirements {
  const model::Target& target;
  const model::Rules& rules;
  const symmetry::Group* symmetry = nullptr;  // null: none
  double min_eigenvalue = 0.0;                // softer networks are not entered
  int max_floating = 1;  // components of rods that are free of each other, at most
  int fixed_cables = 0;  // so many of the first cables stay as they are; only without symmetry
  // Its max_deviation: networks that errors move further are not entered.
  Workmanship workmanship{};
  double standing_deviation = std::numeric_limits<double>::infinity();  // of what stands, at most
};

// The mismatch in `norm` plus stability_weight * sum of softness over the softest modes, which is
//   10 min_eigenvalue / eigenvalue + (2 standard deviations of its motion by errors /
//   max_deviation)^2:
// networks are kept clear of the loss of stability, and of poses that errors of their cables
// change.
struct Objective {
  Norm norm{};
  double stability_weight = 0.0;
  // What the rules and the workmanship ask of a network that is built: gaps, and no cable much
  // weaker than the strongest. Bounds on steps; else it is left for later.
  bool buildable = false;
};

class FittedNetwork {
 public:
  FittedNetwork(const network::Network& network, const Requirements& requirements,
                const Objective& objective, const StepOptions& options,
                const network::Control& control);

  // From another network with the same rods. false when it is not in stable equilibrium: then
  // usable() stays false until the next restart that succeeds.
  bool restart(const network::Network& network);
  bool usable() const { return usable_; }
  void set(const Objective& objective);

  int cables() const { return static_cast<int>(at_.cables().size()); }
  double value() const { return value_; }  // of the objective
  double softest() const { return soft_.values[0]; }
  const sensitivity::Deviation& deviation() const { return deviation_; }
  const sensitivity::Configuration& at() const { return at_; }
  const equilibrium::SoftModes& soft() const { return soft_; }
  const ErrorResponse& errors() const { return errors_; }
  const Requirements& requirements() const { return requirements_; }
  const Objective& objective() const { return objective_; }
  network::Network network() const { return {at_.system.structure(), at_.state}; }

  // damping_factor: times the damping that the last steps left.
  GaussNewtonModel gauss_newton_model(double damping_factor = 1.0) const;

  // Per orbit, what the objective grows by when its first cable no longer resists stretching, all
  // else held: infinite when the network would not be stable.
  Eigen::VectorXd removal_instability(const LocalModel& local) const;

  // Takes a step of the model's variables (Z), without the orbits `out`, to an equilibrium whose
  // objective is below `max_value`; false: stays.
  bool move(const LocalModel& local, const Eigen::VectorXd& step, const std::vector<int>& out,
            double max_value);

  // At most so many damped Gauss-Newton steps, until one gains less than this part.
  void refit(int steps, double min_gain = 0.02);

  // For optimizers that try networks of their own. evaluate() gives the objective with these cables
  // at the equilibrium found from `predicted`; none when that is not valid. It leaves the network
  // as it is and remembers the trial, to which the others refer.
  std::optional<double> evaluate(std::vector<springs::Cable> cables, model::State predicted);
  GaussNewtonModel trial_model() const;
  network::Network trial_network() const { return {trial_.system.structure(), trial_.state}; }
  void accept_trial() { accept(); }

  const network::SolveCounts& counts() const { return counts_; }
  bool stopped() const { return control_.stop.stop_requested(); }
  const std::stop_token& stop_token() const { return control_.stop; }

 private:
  // A mode's part in the objective, in units of the stability weight, and its derivative in the
  // mode's eigenvalue.
  struct Softness {
    double value = 0.0;
    double rate = 0.0;
  };
  Softness softness(double eigenvalue, double variance) const;
  bool solve_trial(model::State start, const equilibrium::SoftModes& nearby,
                   const equilibrium::SolveOptions& options);
  bool trial_is_valid() const;
  void accept();
  double evaluate(const Eigen::VectorXd& residual, const equilibrium::SoftModes& soft,
                  const ErrorResponse& errors) const;
  GaussNewtonModel model_at(const sensitivity::Configuration& at,
                            const equilibrium::SoftModes& soft, const ErrorResponse& errors,
                            double damping_factor) const;
  Squares stability_terms(const LocalModel& local, const sensitivity::Configuration& at,
                          const equilibrium::SoftModes& soft, const ErrorResponse& errors) const;
  StepBounds step_bounds(const LocalModel& local) const;

  Requirements requirements_;
  Objective objective_;
  StepOptions options_;
  network::Control control_;
  sensitivity::Configuration at_, trial_;
  equilibrium::SoftModes soft_, trial_soft_;
  ErrorResponse errors_, trial_errors_;
  sensitivity::Deviation deviation_, trial_deviation_;
  double value_ = 0.0, trial_value_ = 0.0;
  double damping_;
  linalg::SymmetricFactor workspace_;
  bool usable_ = false;
  network::SolveCounts counts_;
};

}  // namespace tencer::elimination
