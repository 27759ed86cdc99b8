#include <cmath>
#include <tencer/core/error.hpp>
#include <tencer/registration/seen.hpp>
#include <tencer/sensitivity/distance.hpp>
#include <utility>

#include "alignment.hpp"

namespace tencer::sensitivity {
namespace {

using model::State;

// The motions in which the alignment follows the state.
Motions allowed_motions(const model::Target& target) {
  if (!target.align) return Motions::none;
  return target.planar ? Motions::in_plane : Motions::in_space;
}

// Rods side by side, as one set of points.
struct Stacked {
  Eigen::Matrix3Xd x, target;
  Eigen::VectorXd weights;
};

Stacked stack(const model::Target& target, const State& state) {
  Eigen::Index count = 0;
  for (const auto& points : target.points) count += points.cols();
  Stacked all{.x = Eigen::Matrix3Xd(3, count),
              .target = Eigen::Matrix3Xd(3, count),
              .weights = Eigen::VectorXd(count)};
  Eigen::Index first = 0;
  for (std::size_t r = 0; r < state.size(); ++r) {
    const Eigen::Index n = state[r].x.cols();
    all.x.middleCols(first, n) = state[r].x;
    all.target.middleCols(first, n) = target.points[r];
    all.weights.segment(first, n) = weights_of(target, r);
    first += n;
  }
  return all;
}

// Of distances in the frame of the state.
Eigen::Matrix3d seeing(const model::Target& target, const registration::RigidMotion& motion) {
  return model::seeing(model::turned(target.views, motion.rotation));
}

registration::RigidMotion alignment(const model::Target& target, const Stacked& all) {
  if (!target.align) return {};
  if (!target.views.empty())
    return registration::align_seen(all.target, all.x, all.weights,
                                    model::seen_metric(target.views));
  return (target.planar ? registration::align_in_plane : registration::align)(all.target, all.x,
                                                                              all.weights);
}

Deviation measure(const model::Target& target, const Stacked& all) {
  Deviation result{.motion = alignment(target, all)};
  const Eigen::Matrix3Xd away = all.x - result.motion.apply(all.target);
  const Eigen::VectorXd squares =
      (seeing(target, result.motion) * away).colwise().squaredNorm().transpose();
  result.value = all.weights.dot(squares);
  result.rms = std::sqrt(result.value / all.weights.sum());
  result.max = std::sqrt((all.weights.array() > 0).select(squares, 0).maxCoeff());
  const double diagonal =
      (all.target.rowwise().maxCoeff() - all.target.rowwise().minCoeff()).norm();
  result.max_percent = 100 * result.max / diagonal;
  result.rms_percent = 100 * result.rms / diagonal;
  return result;
}

// `by` times the three rows of each vertex.
Eigen::MatrixXd mapped(Eigen::MatrixXd v, const Eigen::Matrix3d& by) {
  for (Eigen::Index row = 0; row < v.rows(); row += 3)
    v.middleRows<3>(row) = (by * v.middleRows<3>(row)).eval();
  return v;
}

}  // namespace

Deviation deviation(const model::Target& target, const State& state) {
  return measure(target, stack(target, state));
}

std::vector<model::View> views_at(const model::Target& target, const State& state) {
  if (target.views.empty() || !target.align) return target.views;
  return model::turned(target.views, alignment(target, stack(target, state)).rotation);
}

Distance::Distance(const model::Target& target, const equilibrium::System& system,
                   const State& state) {
  validate(target, system.structure());
  const Stacked all = stack(target, state);
  deviation_ = measure(target, all);
  const Eigen::Matrix3Xd y = deviation_.motion.apply(all.target);
  const Eigen::Matrix3Xd away = all.x - y;
  const Eigen::Matrix3d root = seeing(target, deviation_.motion);
  const Eigen::Matrix3d metric = root * root;
  roots_ = all.weights.cwiseSqrt().transpose().replicate<3, 1>().reshaped();
  residual_ = roots_.cwiseProduct((root * away).reshaped());
  const Alignment taken = target.align && !target.views.empty()
                              ? alignment_seen(all.x, y, all.weights, metric)
                              : alignment_in_space(all.x, y, all.weights, allowed_motions(target));
  motions_ = taken.gauss_newton.motions;
  compliance_ = taken.exact.compliance;
  gauss_compliance_ = taken.gauss_newton.compliance;
  if (!target.views.empty()) seeing_ = root;

  gradient_ = Eigen::VectorXd::Zero(system.size());
  weights_ = Eigen::VectorXd::Zero(system.size());
  forces_ = Eigen::MatrixXd::Zero(system.size(), motions_.cols());
  gauss_forces_ = forces_;
  rows_.assign(system.size(), -1);
  const Eigen::Matrix3Xd pulling = metric * away;
  Eigen::Index column = 0;
  for (int r = 0; r < static_cast<int>(state.size()); ++r)
    for (int v = 0; v < state[r].x.cols(); ++v, ++column)
      for (int axis = 0; axis < 3; ++axis) {
        const int at = system.position_index(r, v, axis);
        if (at < 0) continue;
        const Eigen::Index row = 3 * column + axis;
        rows_[at] = static_cast<int>(row);
        weights_[at] = all.weights[column];
        gradient_[at] = 2 * all.weights[column] * pulling(axis, column);
        forces_.row(at) = taken.exact.forces.row(row);
        gauss_forces_.row(at) = taken.gauss_newton.forces.row(row);
      }
}

Eigen::MatrixXd Distance::in_rows(const Eigen::Ref<const Eigen::MatrixXd>& v) const {
  Eigen::MatrixXd result = Eigen::MatrixXd::Zero(roots_.size(), v.cols());
  for (std::size_t i = 0; i < rows_.size(); ++i)
    if (rows_[i] >= 0) result.row(rows_[i]) = v.row(static_cast<Eigen::Index>(i));
  return result;
}

Eigen::MatrixXd Distance::hessian_times(const Eigen::Ref<const Eigen::MatrixXd>& v) const {
  const Eigen::MatrixXd taken_up = forces_ * (compliance_ * (forces_.transpose() * v));
  if (!seeing_) return 2 * (weights_.asDiagonal() * v - taken_up);
  const Eigen::MatrixXd rows = mapped(in_rows(v), *seeing_ * *seeing_);
  Eigen::MatrixXd result = -2 * taken_up;
  for (std::size_t i = 0; i < rows_.size(); ++i)
    if (rows_[i] >= 0) {
      const auto at = static_cast<Eigen::Index>(i);
      result.row(at) += 2 * weights_[at] * rows.row(rows_[i]);
    }
  return result;
}

Eigen::MatrixXd Distance::residual_rates(const Eigen::Ref<const Eigen::MatrixXd>& v) const {
  Eigen::MatrixXd rates = -motions_ * (gauss_compliance_ * (gauss_forces_.transpose() * v));
  for (std::size_t i = 0; i < rows_.size(); ++i)
    if (rows_[i] >= 0) rates.row(rows_[i]) += v.row(static_cast<Eigen::Index>(i));
  if (seeing_) rates = mapped(std::move(rates), *seeing_);
  return roots_.asDiagonal() * rates;
}

}  // namespace tencer::sensitivity
