#include <Eigen/Eigenvalues>
#include <cmath>
#include <tencer/core/error.hpp>
#include <tencer/sensitivity/distance.hpp>
#include <utility>

namespace tencer::sensitivity {
namespace {

using model::State;

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

Deviation measure(const model::Target& target, const Stacked& all) {
  Deviation result;
  if (target.align)
    result.motion = (target.planar ? registration::align_in_plane : registration::align)(
        all.target, all.x, all.weights);
  const Eigen::VectorXd squares =
      (all.x - result.motion.apply(all.target)).colwise().squaredNorm().transpose();
  result.value = all.weights.dot(squares);
  result.rms = std::sqrt(result.value / all.weights.sum());
  result.max = std::sqrt((all.weights.array() > 0).select(squares, 0).maxCoeff());
  const double diagonal =
      (all.target.rowwise().maxCoeff() - all.target.rowwise().minCoeff()).norm();
  result.max_percent = 100 * result.max / diagonal;
  result.rms_percent = 100 * result.rms / diagonal;
  return result;
}

// Inverse on the range; directions that do not count (turning a straight rod about itself) get 0.
Eigen::MatrixXd pseudo_inverse(const Eigen::MatrixXd& symmetric) {
  constexpr double tolerance = 1e-9;
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> eigen(symmetric);
  Eigen::VectorXd inverse = eigen.eigenvalues();
  const double largest = inverse.cwiseAbs().maxCoeff();
  for (double& value : inverse) value = std::abs(value) > tolerance * largest ? 1 / value : 0;
  return eigen.eigenvectors() * inverse.asDiagonal() * eigen.eigenvectors().transpose();
}

// sum w ((a . b) I - (a b^T + b a^T) / 2), half of T's second derivative when the aligned target,
// b from its centre, turns against the shape, a from the same centre. For a = b it is the inertia
// tensor.
Eigen::Matrix3d turning_stiffness(const Eigen::Matrix3Xd& a, const Eigen::Matrix3Xd& b,
                                  const Eigen::VectorXd& w) {
  const Eigen::Matrix3d product = a * w.asDiagonal() * b.transpose();
  return product.trace() * Eigen::Matrix3d::Identity() - (product + product.transpose()) / 2;
}

}  // namespace

Deviation deviation(const model::Target& target, const State& state) {
  return measure(target, stack(target, state));
}

Distance::Distance(const model::Target& target, const equilibrium::System& system,
                   const State& state) {
  validate(target, system.structure());
  const Stacked all = stack(target, state);
  deviation_ = measure(target, all);
  const Eigen::Matrix3Xd y = deviation_.motion.apply(all.target);
  const Eigen::Matrix3Xd away = all.x - y;
  roots_ = all.weights.cwiseSqrt().transpose().replicate<3, 1>().reshaped();
  residual_ = roots_.cwiseProduct(away.reshaped());

  // Motions of y: shifts, then turns about its centre.
  const Eigen::Vector3d centre = y * all.weights / all.weights.sum();
  const Eigen::Matrix3Xd b = y.colwise() - centre;
  Eigen::MatrixXd motions(3 * y.cols(), 6);
  for (Eigen::Index i = 0; i < y.cols(); ++i) {
    const Eigen::Vector3d arm = b.col(i);
    motions.block<3, 3>(3 * i, 0).setIdentity();
    motions.block<3, 3>(3 * i, 3) << 0, arm.z(), -arm.y(), -arm.z(), 0, arm.x(), arm.y(), -arm.x(),
        0;
  }
  std::vector<int> shifts, turns;
  if (target.align) {
    shifts = target.planar ? std::vector<int>{0, 1} : std::vector<int>{0, 1, 2};
    turns = target.planar ? std::vector<int>{5} : std::vector<int>{3, 4, 5};
  }
  std::vector<int> allowed = shifts;
  allowed.insert(allowed.end(), turns.begin(), turns.end());
  motions_ = motions(Eigen::all, allowed);
  const auto compliance = [&](const Eigen::Matrix3Xd& a) -> Eigen::MatrixXd {
    Eigen::MatrixXd inverse = Eigen::MatrixXd::Zero(6, 6);
    for (int i : shifts) inverse(i, i) = 1 / all.weights.sum();
    Eigen::MatrixXd stiffness = Eigen::MatrixXd::Zero(6, 6);
    stiffness.bottomRightCorner<3, 3>() = turning_stiffness(a, b, all.weights);
    if (!turns.empty()) inverse(turns, turns) = pseudo_inverse(stiffness(turns, turns));
    return inverse(allowed, allowed);
  };
  compliance_ = compliance(all.x.colwise() - centre);
  gauss_compliance_ = compliance(b);

  gradient_ = Eigen::VectorXd::Zero(system.size());
  weights_ = Eigen::VectorXd::Zero(system.size());
  weighted_motions_ = Eigen::MatrixXd::Zero(system.size(), motions_.cols());
  rows_.assign(system.size(), -1);
  Eigen::Index column = 0;
  for (int r = 0; r < static_cast<int>(state.size()); ++r)
    for (int v = 0; v < state[r].x.cols(); ++v, ++column)
      for (int axis = 0; axis < 3; ++axis) {
        const int at = system.position_index(r, v, axis);
        if (at < 0) continue;
        const Eigen::Index row = 3 * column + axis;
        rows_[at] = static_cast<int>(row);
        weights_[at] = all.weights[column];
        gradient_[at] = 2 * all.weights[column] * away(axis, column);
        weighted_motions_.row(at) = all.weights[column] * motions_.row(row);
      }
}

Eigen::MatrixXd Distance::hessian_times(const Eigen::Ref<const Eigen::MatrixXd>& v) const {
  return 2 * (weights_.asDiagonal() * v -
              weighted_motions_ * (compliance_ * (weighted_motions_.transpose() * v)));
}

Eigen::MatrixXd Distance::residual_rates(const Eigen::Ref<const Eigen::MatrixXd>& v) const {
  Eigen::MatrixXd rates = -motions_ * (gauss_compliance_ * (weighted_motions_.transpose() * v));
  for (std::size_t i = 0; i < rows_.size(); ++i)
    if (rows_[i] >= 0) rates.row(rows_[i]) += v.row(static_cast<Eigen::Index>(i));
  return roots_.asDiagonal() * rates;
}

}  // namespace tencer::sensitivity
