#include <algorithm>
#include <cmath>
#include <span>
#include <tencer/equilibrium/modal.hpp>
#include <tencer/ground_structure/balanced_tensions.hpp>
#include <tencer/linalg/symmetric_factor.hpp>
#include <utility>

#include "compliance.hpp"

namespace tencer::ground_structure {
namespace {

// The least-squares problem with columns worked out only for candidates that are ever in the set.
class Balance {
 public:
  Balance(const equilibrium::System& bare, const model::State& state,
          const std::vector<CandidateOrbit>& orbits, linalg::SymmetricFactor factor)
      : bare_(bare),
        orbits_(orbits),
        factor_(std::move(factor)),
        positions_(equilibrium::lumped_mass(bare)),
        solution_(bare.size()),
        columns_(orbits.size()) {
    for (double& entry : positions_) entry = entry > 0 ? 1.0 : 0.0;
    goal_ = displacement(-bare.gradient(state));
  }

  const Eigen::VectorXd& goal() const { return goal_; }

  // What is left of the goal.
  Eigen::VectorXd residual(std::span<const int> set, const Eigen::VectorXd& values) {
    Eigen::VectorXd rest = goal_;
    for (std::size_t i = 0; i < set.size(); ++i)
      rest -= values[static_cast<Eigen::Index>(i)] * column(set[i]);
    return rest;
  }

  // The products of every column with what is left.
  void slope(std::span<const int> set, const Eigen::VectorXd& values, Eigen::VectorXd& slope) {
    const Eigen::VectorXd back = displacement(residual(set, values));
    slope.setZero(static_cast<Eigen::Index>(orbits_.size()));
    for (Eigen::Index c = 0; c < slope.size(); ++c)
      for (const CandidateColumn& column : orbits_[c])
        for_each_unknown(bare_, column,
                         [&](int i, double weight) { slope[c] += weight * back[i]; });
  }

  // The products of column j with those of the set and with itself.
  Eigen::VectorXd products(std::span<const int> set, int j) {
    Eigen::VectorXd result(static_cast<Eigen::Index>(set.size()) + 1);
    for (std::size_t i = 0; i < set.size(); ++i)
      result[static_cast<Eigen::Index>(i)] = column(set[i]).dot(column(j));
    result[result.size() - 1] = column(j).squaredNorm();
    return result;
  }

  // Whether no vertex moves by more than `accuracy`.
  bool small(const Eigen::VectorXd& motion, double accuracy) const {
    const auto& rods = bare_.structure().rods;
    for (int r = 0; r < static_cast<int>(rods.size()); ++r)
      for (int v = 0; v < rods[r].vertices(); ++v) {
        double squared = 0;
        for (int axis = 0; axis < 3; ++axis)
          if (const int i = bare_.position_index(r, v, axis); i >= 0)
            squared += motion[i] * motion[i];
        if (squared > accuracy * accuracy) return false;
      }
    return true;
  }

 private:
  Eigen::VectorXd displacement(const Eigen::VectorXd& force) {
    factor_.solve(force, solution_);
    return solution_.cwiseProduct(positions_);
  }

  const Eigen::VectorXd& column(int c) {
    if (columns_[c].size() == 0) {
      Eigen::VectorXd force = Eigen::VectorXd::Zero(bare_.size());
      for (const CandidateColumn& column : orbits_[c])
        for_each_unknown(bare_, column, [&](int i, double weight) { force[i] += weight; });
      columns_[c] = displacement(force);
    }
    return columns_[c];
  }

  const equilibrium::System& bare_;
  const std::vector<CandidateOrbit>& orbits_;
  linalg::SymmetricFactor factor_;
  Eigen::VectorXd positions_;  // 1 for positions, 0 for other unknowns
  Eigen::VectorXd solution_;
  Eigen::VectorXd goal_;
  std::vector<Eigen::VectorXd> columns_;  // empty until asked for
};

}  // namespace

std::optional<Displacements> displacements(const equilibrium::System& bare,
                                           const model::State& state,
                                           const std::vector<CandidateOrbit>& orbits) {
  const auto factor = compliance(bare, state);
  if (!factor) return std::nullopt;
  Eigen::MatrixXd forces =
      Eigen::MatrixXd::Zero(bare.size(), static_cast<Eigen::Index>(orbits.size()) + 1);
  for (Eigen::Index c = 0; c + 1 < forces.cols(); ++c)
    for (const CandidateColumn& column : orbits[c])
      for_each_unknown(bare, column, [&](int i, double weight) { forces(i, c) += weight; });
  forces.rightCols<1>() = -bare.gradient(state);
  Eigen::MatrixXd moved = factor->solve(forces);
  const Eigen::VectorXd mass = equilibrium::lumped_mass(bare);
  for (Eigen::Index i = 0; i < moved.rows(); ++i)
    if (!(mass[i] > 0)) moved.row(i).setZero();
  return Displacements{.columns = moved.leftCols(forces.cols() - 1), .goal = moved.rightCols<1>()};
}

std::optional<linalg::Nonnegative> balanced_tensions(const equilibrium::System& bare,
                                                     const model::State& state,
                                                     const std::vector<CandidateOrbit>& orbits,
                                                     double accuracy) {
  // A group of symmetries may leave none.
  if (orbits.empty()) return linalg::Nonnegative{.reason = linalg::NonnegativeReason::solved};
  auto factor = compliance(bare, state);
  if (!factor) return std::nullopt;
  Balance balance(bare, state, orbits, std::move(*factor));
  if (balance.small(balance.goal(), accuracy))
    return linalg::Nonnegative{.reason = linalg::NonnegativeReason::enough};
  linalg::NonnegativeProblem problem{.size = static_cast<int>(orbits.size())};
  problem.slope = [&](std::span<const int> set, const Eigen::VectorXd& values,
                      Eigen::VectorXd& slope) { balance.slope(set, values, slope); };
  problem.column = [&](std::span<const int> set, int j) { return balance.products(set, j); };
  problem.enough = [&](std::span<const int> set, const Eigen::VectorXd& values) {
    return balance.small(balance.residual(set, values), accuracy);
  };
  Eigen::VectorXd slope;
  balance.slope({}, {}, slope);
  if (!slope.allFinite()) return std::nullopt;
  return linalg::solve_nonnegative(problem, {.tolerance = 1e-9 * slope.cwiseAbs().maxCoeff()});
}

}  // namespace tencer::ground_structure
