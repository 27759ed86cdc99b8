#include <algorithm>
#include <cmath>
#include <tencer/equilibrium/modal.hpp>
#include <tencer/ground_structure/feasibility.hpp>

#include "compliance.hpp"

namespace tencer::ground_structure {
namespace {

class Dual {
 public:
  Dual(const equilibrium::System& bare, const model::State& state,
       const std::vector<CandidateOrbit>& orbits, const linalg::SymmetricFactor& compliance)
      : bare_(bare),
        orbits_(orbits),
        compliance_(compliance),
        positions_(equilibrium::lumped_mass(bare)),
        forces_(-bare.gradient(state)) {
    for (double& entry : positions_) entry = entry > 0 ? 1.0 : 0.0;
    forces_ = forces_.cwiseProduct(positions_);
  }

  // Where the rods go with these tensions.
  Eigen::VectorXd motion(std::span<const int> set, const Eigen::VectorXd& values) const {
    Eigen::VectorXd rest = forces_;
    for (std::size_t i = 0; i < set.size(); ++i)
      add(set[i], -values[static_cast<Eigen::Index>(i)], rest);
    return moved(rest);
  }

  // By how much a motion lengthens a candidate, with its images.
  double lengthening(int c, const Eigen::VectorXd& motion) const {
    double sum = 0;
    for (const CandidateColumn& column : orbits_[c])
      for_each_unknown(bare_, column, [&](int i, double weight) { sum += weight * motion[i]; });
    return sum;
  }

  Eigen::VectorXd products(std::span<const int> set, int j) const {
    Eigen::VectorXd pull = Eigen::VectorXd::Zero(bare_.size());
    add(j, 1, pull);
    const Eigen::VectorXd motion = moved(pull);
    Eigen::VectorXd result(static_cast<Eigen::Index>(set.size()) + 1);
    for (std::size_t i = 0; i < set.size(); ++i)
      result[static_cast<Eigen::Index>(i)] = lengthening(set[i], motion);
    result[result.size() - 1] = lengthening(j, motion);
    return result;
  }

  const Eigen::VectorXd& forces() const { return forces_; }

 private:
  void add(int c, double tension, Eigen::VectorXd& force) const {
    for (const CandidateColumn& column : orbits_[c])
      for_each_unknown(bare_, column, [&](int i, double weight) { force[i] += tension * weight; });
  }

  Eigen::VectorXd moved(const Eigen::VectorXd& force) const {
    return compliance_.solve(force).cwiseProduct(positions_);
  }

  const equilibrium::System& bare_;
  const std::vector<CandidateOrbit>& orbits_;
  const linalg::SymmetricFactor& compliance_;
  Eigen::VectorXd positions_;  // 1 for positions, 0 for other unknowns
  Eigen::VectorXd forces_;
};

}  // namespace

std::optional<Relaxation> relaxation(const equilibrium::System& bare, const model::State& state,
                                     const std::vector<CandidateOrbit>& orbits) {
  const auto factor = compliance(bare, state);
  if (!factor) return std::nullopt;
  const Dual dual(bare, state, orbits, *factor);
  linalg::NonnegativeProblem problem{.size = static_cast<int>(orbits.size())};
  problem.slope = [&](std::span<const int> set, const Eigen::VectorXd& values,
                      Eigen::VectorXd& slope) {
    const Eigen::VectorXd motion = dual.motion(set, values);
    slope.resize(problem.size);
    for (int c = 0; c < problem.size; ++c) slope[c] = dual.lengthening(c, motion);
  };
  problem.column = [&](std::span<const int> set, int j) { return dual.products(set, j); };
  Eigen::VectorXd slope;
  problem.slope({}, {}, slope);
  if (!slope.allFinite()) return std::nullopt;
  Relaxation result;
  if (problem.size > 0)
    result.tensions =
        linalg::solve_nonnegative(problem, {.tolerance = 1e-9 * slope.cwiseAbs().maxCoeff()});
  result.motion = dual.motion(result.tensions.set, result.tensions.values);
  result.power = dual.forces().dot(result.motion);
  for (int c = 0; c < problem.size; ++c)
    result.lengthening = std::max(result.lengthening, dual.lengthening(c, result.motion));
  const auto& rods = bare.structure().rods;
  for (int r = 0; r < static_cast<int>(rods.size()); ++r)
    for (int v = 0; v < rods[r].vertices(); ++v) {
      double squared = 0;
      for (int axis = 0; axis < 3; ++axis)
        if (const int i = bare.position_index(r, v, axis); i >= 0)
          squared += result.motion[i] * result.motion[i];
      result.largest = std::max(result.largest, std::sqrt(squared));
    }
  return result;
}

}  // namespace tencer::ground_structure
