#include "stretch.hpp"

#include <Eigen/Cholesky>
#include <Eigen/LU>
#include <limits>
#include <optional>
#include <tencer/linalg/dense.hpp>

#include "remainder.hpp"

namespace tencer::lower_bound {
namespace {

using Eigen::Index;

// The matrix of sum_i a_i |g_i|^2 + b_i |psi_i|^2 of test functions; its lower half.
Eigen::MatrixXd weighted_squares(const WeakForm& form, const Eigen::MatrixXd& g,
                                 const Eigen::VectorXd& a, const Eigen::VectorXd& b) {
  const Eigen::VectorXd roots = a.cwiseSqrt().transpose().replicate<3, 1>().reshaped();
  const Eigen::MatrixXd scaled = (roots.asDiagonal() * g).transpose();
  Eigen::MatrixXd squares = Eigen::MatrixXd::Zero(g.cols(), g.cols());
  squares.selfadjointView<Eigen::Lower>().rankUpdate(scaled);
  const Eigen::MatrixXd sizes = form.splines.transpose() * b.asDiagonal() * form.splines;
  for (Index j = 0; j < sizes.rows(); ++j)
    for (Index k = 0; k < sizes.cols(); ++k)
      squares.block<3, 3>(3 * j, 3 * k).diagonal().array() += sizes(j, k);
  return squares;
}

// Coefficients of test functions, a column each, with demands * z = wanted and a small remainder:
// the sum of lengths of g's vectors and of psi's, these times their cost, by least squares weighted
// anew. Nothing depends on how small: remainder() tells.
Eigen::MatrixXd small_tests(const WeakForm& form, const Parameters& centre, const Pose& pose,
                            const Eigen::MatrixXd& demands, const Eigen::MatrixXd& wanted,
                            int rounds) {
  const Index n = form.vertices();
  const Eigen::MatrixXd g = form.g(centre);
  const Eigen::VectorXd cost = cost_of_size(form, pose, centre);
  Eigen::VectorXd g_weight = Eigen::VectorXd::Ones(n);
  Eigen::VectorXd psi_weight = Eigen::VectorXd::Zero(n);
  const auto lengths = [&](const Eigen::MatrixXd& functions) -> Eigen::VectorXd {
    return functions.rowwise().squaredNorm().reshaped(3, n).colwise().sum().cwiseSqrt();
  };
  constexpr double rounding = std::numeric_limits<double>::epsilon();
  Eigen::MatrixXd z;
  for (int round = 0; round <= rounds; ++round) {
    Eigen::MatrixXd squares = weighted_squares(form, g, g_weight, psi_weight);
    squares.diagonal().array() += 1e-10 * squares.trace();
    const Eigen::MatrixXd reach = squares.ldlt().solve(demands.transpose());
    const Eigen::MatrixXd seen = demands * reach;
    z = reach * linalg::least_squares(seen, wanted, rounding * static_cast<double>(seen.rows()));
    const Eigen::VectorXd g_size = lengths(g * z);
    const Eigen::VectorXd psi_size = lengths(form.psi * z);
    g_weight = form.error / (g_size.array() + 1e-2 * g_size.mean());
    psi_weight = cost.array() / (psi_size.array() + 1e-2 * psi_size.mean());
  }
  return z;
}

// Test functions that tell the parameters: c = the unit vectors, in two groups of three.
struct Tellers {
  Eigen::MatrixXd A{}, F{};
};

Tellers tellers(const WeakForm& form, const Parameters& centre, const Pose& pose, int rounds) {
  const Eigen::MatrixXd unit = Eigen::MatrixXd::Identity(6, 6);
  return {.A = small_tests(form, centre, pose, form.c, unit.leftCols(3), rounds),
          .F = small_tests(form, centre, pose, form.c, unit.rightCols(3), rounds)};
}

Parameters told(const WeakForm& form, const Tellers& z) {
  Parameters p;
  p << (form.d * z.A).transpose(), (form.d * z.F).transpose();
  return p;
}

// Where the parameters are of all poses within the error; not set: not known.
std::optional<Range> range_of(const WeakForm& form, const Pose& pose, const Tellers& z) {
  Range range{.centre = told(form, z)};
  // For a, f, how far A and F are off: (a, f) <= fixed + per (a, f).
  Eigen::Vector2d fixed;
  Eigen::Matrix2d per;
  for (const int row : {0, 1}) {
    const Eigen::MatrixXd& own = row == 0 ? z.A : z.F;
    const Remainder bound = remainder(form, pose, range.centre, own);
    Eigen::MatrixXd missed = form.c * own;  // 0 but for rounding, where they can be told at all
    missed.middleRows<3>(3 * row) -= Eigen::Matrix3d::Identity();
    fixed[row] = bound.fixed + (missed.transpose() * range.centre).norm();
    per.row(row) << bound.per_A + missed.topRows<3>().norm(),
        bound.per_F + missed.bottomRows<3>().norm();
  }
  const Eigen::Matrix2d left = Eigen::Matrix2d::Identity() - per;
  const Eigen::Vector2d radius = left.inverse() * fixed;
  // A solution with positive entries proves that I - per has an inverse of entries >= 0.
  if (!radius.allFinite() || !(radius.array() > 0).all()) return std::nullopt;
  range.A_radius = 1.001 * radius[0];
  range.F_radius = 1.001 * radius[1];
  return range;
}

}  // namespace

bool needs_force(const Stretch& stretch) {
  constexpr double in_hand = 1.01;
  constexpr int fewest_vertices = 8;
  if (stretch.target.cols() < fewest_vertices) return false;
  const WeakForm form = weak_form(stretch);
  Pose pose = any_pose(form);
  Parameters centre = Parameters::Zero();
  std::optional<Range> range;
  for (const int rounds : {0, 2, 2}) {
    const Tellers z = tellers(form, centre, pose, rounds);
    centre = told(form, z);
    const auto next = range_of(form, pose, z);
    if (next && (!range || next->F_radius < range->F_radius)) range = next;
    if (range) pose = pose_within(form, *range);
  }
  if (!range) return false;
  Eigen::MatrixXd demands(7, form.psi.cols());
  demands << form.c, form.d;
  const Eigen::MatrixXd z =
      small_tests(form, range->centre, pose, demands, Eigen::MatrixXd::Identity(7, 7).col(6), 5);
  const Remainder bound = remainder(form, pose, range->centre, z);
  const Parameters c = form.c * z;
  const double seen = std::abs((form.d * z)(0) - range->centre.dot(c));
  const double most = bound.fixed + (bound.per_A + c.head<3>().norm()) * range->A_radius +
                      (bound.per_F + c.tail<3>().norm()) * range->F_radius;
  return seen > in_hand * most;
}

}  // namespace tencer::lower_bound
