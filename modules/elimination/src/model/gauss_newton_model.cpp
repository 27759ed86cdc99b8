#include "model/gauss_newton_model.hpp"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <limits>
#include <tencer/linalg/nonnegative.hpp>

namespace tencer::elimination {
namespace {

Eigen::VectorXd distances_of(const Eigen::VectorXd& residual) {
  return residual.reshaped(3, residual.size() / 3).colwise().norm().transpose();
}

// Stretches the rows of each vertex along its residual's direction.
void stretch(const Eigen::VectorXd& residual, const Eigen::VectorXd& distances, double factor,
             Eigen::MatrixXd& rows) {
  for (Eigen::Index i = 0; i < distances.size(); ++i) {
    if (!(distances[i] > 0)) continue;
    const Eigen::Vector3d unit = residual.segment<3>(3 * i) / distances[i];
    const Eigen::RowVectorXd along = unit.transpose() * rows.middleRows(3 * i, 3);
    rows.middleRows(3 * i, 3) += (factor - 1) * unit * along;
  }
}

}  // namespace

double mismatch(const Eigen::VectorXd& residual, const Norm& norm) {
  const Eigen::VectorXd distances = distances_of(residual);
  const double largest = distances.maxCoeff();
  if (!(largest > 0)) return 0;
  return std::pow(largest / norm.unit, 2) *
         std::pow((distances / largest).array().pow(norm.power).mean(), 2 / norm.power);
}

// The mean of powers is taken as a sum of squares of the same slope and, but for the curvature of
// the motion itself, no less curvature.
GaussNewtonModel::GaussNewtonModel(LocalModel local, const Norm& norm, const Squares& further,
                                   const Eigen::VectorXd& damping, StepBounds bounds)
    : local_(std::move(local)), bounds_(std::move(bounds)), radial_(std::sqrt(norm.power - 1)) {
  constexpr double min_share = 1e-2;  // keeps vertices that happen to fit in the problem
  const Eigen::VectorXd& residual = local_.distance.residual;
  const Eigen::VectorXd distances = distances_of(residual);
  const Eigen::Index vertices = distances.size();
  const double largest = std::max(distances.maxCoeff(), 1e-12 * norm.unit);
  const Eigen::ArrayXd shares = (distances / largest).array();
  const double scale = std::sqrt(std::pow(shares.pow(norm.power).mean(), 2 / norm.power - 1) /
                                 static_cast<double>(vertices)) /
                       norm.unit;
  roots_ = scale * shares.max(min_share).pow(norm.power / 2 - 1);
  const Eigen::Index rows = 3 * vertices;
  const Eigen::VectorXd row_roots = roots_.transpose().replicate(3, 1).reshaped();
  residual_.resize(rows + further.value.size());
  residual_.head(rows) = residual.cwiseProduct(row_roots) / radial_;
  residual_.tail(further.value.size()) = further.value;
  Eigen::MatrixXd weighted = row_roots.asDiagonal() * local_.distance.jacobian;
  if (radial_ != 1) stretch(residual, distances, radial_, weighted);
  jacobian_.resize(residual_.size(), weighted.cols());
  jacobian_.topRows(rows) = weighted;
  jacobian_.bottomRows(further.value.size()) = further.rates;

  Eigen::MatrixXd normal = Eigen::MatrixXd::Zero(jacobian_.cols(), jacobian_.cols());
  normal.selfadjointView<Eigen::Lower>().rankUpdate(jacobian_.transpose());
  normal.diagonal() += damping;
  const Eigen::LLT<Eigen::MatrixXd, Eigen::Lower> factor(normal);
  inverse_ = factor.solve(Eigen::MatrixXd::Identity(normal.rows(), normal.cols()));
  step_ = -(inverse_ * (jacobian_.transpose() * residual_));
}

Eigen::VectorXd GaussNewtonModel::removal_costs() const {
  const double reached = (residual_ + jacobian_ * step_).squaredNorm();
  Eigen::VectorXd costs(local_.density.size());
  for (Eigen::Index o = 0; o < costs.size(); ++o) {
    const auto rate = local_.density_rates.row(o);
    const double left = local_.density[o] + rate.dot(step_);
    costs[o] = reached + left * left / (rate * inverse_ * rate.transpose()).value();
  }
  return costs;
}

Eigen::VectorXd GaussNewtonModel::step(const std::vector<int>& out, double part) const {
  Eigen::VectorXd start = part * step_;
  Eigen::MatrixXd inverse = inverse_;
  if (!out.empty()) {
    const Eigen::MatrixXd rates = local_.density_rates(out, Eigen::all);
    const Eigen::MatrixXd response = inverse_ * rates.transpose();
    const auto factor = Eigen::MatrixXd(rates * response).ldlt();
    const Eigen::VectorXd density = local_.density(out);
    start += response * factor.solve(-part * density - rates * start);
    inverse -= response * factor.solve(response.transpose());
  }
  const Eigen::VectorXd nowhere =
      Eigen::VectorXd::Constant(start.size(), std::numeric_limits<double>::quiet_NaN());
  if (!start.allFinite() || !inverse.allFinite()) return nowhere;
  // The bounds that matter are few: those that the step runs into, found in turns.
  constexpr int turns = 10;
  Eigen::VectorXd step = start;
  std::vector<int> active;
  for (int turn = 0; turn < turns; ++turn) {
    const Eigen::VectorXd slack = bounds_.rows * step - bounds_.lower;
    const std::size_t known = active.size();
    for (int i = 0; i < static_cast<int>(slack.size()); ++i)
      if (slack[i] < -1e-9 * (1 + std::abs(bounds_.lower[i])) &&
          std::ranges::find(out, i) == out.end() &&
          std::find(active.begin(), active.begin() + known, i) == active.begin() + known)
        active.push_back(i);
    if (active.size() == known) break;
    const Eigen::MatrixXd rows = bounds_.rows(active, Eigen::all);
    const Eigen::MatrixXd response = inverse * rows.transpose();
    const Eigen::VectorXd missing = bounds_.lower(active) - rows * start;
    // Rounding may leave a bound that the orbits taken out fulfil already with less than nothing.
    Eigen::MatrixXd compliance = rows * response;
    if (!compliance.allFinite() || !missing.allFinite()) return nowhere;
    compliance.diagonal() = compliance.diagonal().cwiseMax(0.0);
    const auto forces = linalg::solve_nonnegative(
        compliance, missing, {.tolerance = 1e-9 * missing.cwiseAbs().maxCoeff()});
    step = start;
    for (std::size_t i = 0; i < forces.set.size(); ++i)
      step += forces.values[static_cast<Eigen::Index>(i)] * response.col(forces.set[i]);
  }
  return step;
}

GaussNewtonModel::Gain GaussNewtonModel::gain(const Eigen::VectorXd& residual_rates) const {
  const Eigen::VectorXd distances = distances_of(local_.distance.residual);
  Eigen::MatrixXd column =
      residual_rates.cwiseProduct(Eigen::VectorXd(roots_.transpose().replicate(3, 1).reshaped()));
  if (radial_ != 1) stretch(local_.distance.residual, distances, radial_, column);
  const Eigen::Index rows = column.rows();
  const Eigen::VectorXd shared = jacobian_.topRows(rows).transpose() * column;
  const double curvature = column.squaredNorm() - shared.dot(inverse_ * shared);
  const double slope = column.col(0).dot(residual_.head(rows) + jacobian_.topRows(rows) * step_);
  if (!(slope < 0) || !(curvature > 0)) return {};
  return {.value = slope * slope / curvature, .at = -slope / curvature};
}

}  // namespace tencer::elimination
