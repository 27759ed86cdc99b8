#include "state/fit_problem.hpp"

#include <algorithm>
#include <limits>
#include <tencer/network/rest_length.hpp>
#include <utility>

namespace tencer::elimination {

FitProblem::FitProblem(FittedNetwork& fitted, double max_slide)
    : fitted_(fitted),
      model_(fitted.gauss_newton_model()),
      cables_(fitted.at().cables()),
      base_(Eigen::VectorXd::Zero(model_.local().ties.cols())) {
  const LocalModel& local = model_.local();
  const auto& structure = fitted.at().system.structure();
  const model::Rules& rules = fitted.requirements().rules;
  double edge = std::numeric_limits<double>::infinity();
  for (const auto& rod : structure.rods) edge = std::min(edge, rod.rest_lengths.mean());
  scale_ = Eigen::VectorXd::Constant(base_.size(), edge);
  upper_ = Eigen::VectorXd::Constant(base_.size(), max_slide);
  lower_ = -upper_;
  for (const auto& [variable, at] : local.positions) {
    const double own = structure.rods[at.rod].rest_lengths.mean();
    const model::Interval free = sliding_interval(rules, structure, at.rod, at.s);
    scale_[variable] = own;
    lower_[variable] = std::max(-max_slide, (free.lower - at.s) / own);
    upper_[variable] = std::min(max_slide, (free.upper - at.s) / own);
  }
}

bool FitProblem::evaluate(const Eigen::VectorXd& p) {
  if (last_.size() == p.size() && last_ == p) return value_.has_value();
  last_ = p;
  const LocalModel& local = model_.local();
  const Eigen::VectorXd change = local.ties * p.cwiseProduct(scale_);
  auto cables = cables_;
  for (Eigen::Index i = 0; i < change.size(); ++i) {
    const auto [kind, c] = local.parameters[static_cast<std::size_t>(i)];
    if (kind == springs::ParameterKind::rest_length) {
      cables[c].rest_length += change[i];
    } else {
      auto& end = kind == springs::ParameterKind::position_a ? cables[c].a : cables[c].b;
      std::get<springs::OnRod>(end).s += change[i];
    }
  }
  const bool lengths = std::ranges::all_of(
      cables, [](const springs::Cable& cable) { return cable.rest_length > 0; });
  const Eigen::VectorXd motion = local.motion * (p - base_).cwiseProduct(scale_);
  value_.reset();
  if (lengths && motion.allFinite())
    value_ = fitted_.evaluate(std::move(cables),
                              fitted_.at().system.displaced(fitted_.at().state, motion));
  if (value_ && *value_ < best_value_) {
    best_value_ = *value_;
    best_ = fitted_.trial_network();
  }
  return value_.has_value();
}

optimize::Problem FitProblem::problem() {
  optimize::Problem problem;
  problem.lower = lower_;
  problem.upper = upper_;
  problem.value = [this](const Eigen::VectorXd& p) { return evaluate(p) ? value_ : std::nullopt; };
  problem.gradient = [this](const Eigen::VectorXd& p, Eigen::VectorXd& g) {
    if (!evaluate(p)) return false;
    g = fitted_.trial_model().gradient().cwiseProduct(scale_);
    return g.allFinite();
  };
  problem.hessian = [this](const Eigen::VectorXd& p, Eigen::MatrixXd& h) {
    if (!evaluate(p)) return false;
    h = scale_.asDiagonal() * fitted_.trial_model().hessian() * scale_.asDiagonal();
    return h.allFinite();
  };
  return problem;
}

void FitProblem::move_to(const Eigen::VectorXd& p) {
  if (!evaluate(p)) return;
  fitted_.accept_trial();
  model_ = fitted_.gauss_newton_model();
  base_ = p;
  last_.resize(0);
}

void FitProblem::finish() {
  if (!best_) return;
  fitted_.restart(network::rebased(std::move(*best_), network::stiff_rest_ratio));
}

}  // namespace tencer::elimination
