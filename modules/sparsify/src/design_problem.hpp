// The cables of a network as the variables of an outer optimizer (paper section 5.3, eq. 6):
// minimise distance to the target at equilibrium + sparsity.
#pragma once

#include <Eigen/Core>
#include <limits>
#include <optional>
#include <tencer/linalg/symmetric_factor.hpp>
#include <tencer/network/stage.hpp>
#include <tencer/network/stage_recorder.hpp>
#include <tencer/optimize/options.hpp>
#include <tencer/optimize/problem.hpp>
#include <tencer/sensitivity/derivatives.hpp>
#include <tencer/sparsify/outer.hpp>
#include <tencer/springs/parameter.hpp>
#include <vector>

namespace tencer::sparsify {

// p = value / scale, or for a stiffness its root, p = sqrt(k) / scale: with q = 1/2 the sparsity
// term is then linear in p (the paper's K = k^q).
struct Variable {
  springs::Parameter parameter{};
  double scale = 1.0;
  double lower = 0.0;  // of p
  double upper = 0.0;
  double sparsity = 0.0;  // the objective's slope in p
};

inline bool is_stiffness(const Variable& variable) {
  return variable.parameter.kind == springs::ParameterKind::stiffness;
}

struct DesignSetup {
  std::vector<Variable> variables{};
  double distance_scale = 1.0;    // the objective is T / distance_scale + sparsity
  double max_cable_length = 0.0;  // longer cables make an evaluation fail
  double min_eigenvalue =
      0.0;                // softer states make an evaluation fail, see equilibrium::stiffer_than
  bool all_pull = false;  // states in which a cable does not pull make an evaluation fail
  bool exact = false;     // second derivatives: exact, else Gauss-Newton
};

// Values, gradients and Hessians at points p, each at the equilibrium that is followed from the
// last point that move_to() was told of.
class DesignProblem {
 public:
  DesignProblem(const network::Network& network, const model::Target& target, DesignSetup setup,
                const network::Control& control);

  bool usable() const {
    return tracker_.first().usable() && tracker_.committed().linearisation.regular;
  }
  Eigen::VectorXd start() const { return start_; }
  // Refers to this object.
  optimize::Problem problem();
  void move_to(const Eigen::VectorXd& p);

  // The network with the lowest value of all evaluated; none when no evaluation succeeded.
  const std::optional<network::Network>& best() const { return best_; }

  const network::SolveCounts& counts() const { return counts_; }

 private:
  bool evaluate(const Eigen::VectorXd& p);
  std::optional<double> value(const Eigen::VectorXd& p);
  bool gradient(const Eigen::VectorXd& p, Eigen::VectorXd& g);
  bool hessian(const Eigen::VectorXd& p, Eigen::MatrixXd& h);
  Eigen::VectorXd parameter_values(const Eigen::VectorXd& p) const;
  // dv/dp of the parameters' values v, and d2v/dp2.
  Eigen::VectorXd rates(const Eigen::VectorXd& p) const;
  Eigen::VectorXd rate_changes() const;

  model::Target target_;
  DesignSetup setup_;
  std::vector<springs::Parameter> parameters_;
  std::vector<springs::Cable> cables_;
  sensitivity::Tracker tracker_;
  Eigen::VectorXd start_;
  Eigen::VectorXd last_;                           // the point of the tracker's trial
  std::optional<sensitivity::Distance> distance_;  // there; none where it failed
  std::optional<network::Network> best_;
  double best_value_ = std::numeric_limits<double>::infinity();
  linalg::SymmetricFactor workspace_;  // for the test of stiffness
  network::SolveCounts counts_;
};

}  // namespace tencer::sparsify
