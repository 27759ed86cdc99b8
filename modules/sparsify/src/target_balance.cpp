#include "target_balance.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <tencer/core/error.hpp>
#include <tencer/symmetry/orbit.hpp>

#include "soft_modes.hpp"

namespace tencer::sparsify {
namespace {

// Where a cable ends, ordered: the same for a cable and its reversal.
std::array<double, 4> places_of(const springs::Cable& cable, const equilibrium::System& system) {
  const auto place = [&](const springs::End& end) -> std::array<double, 2> {
    if (const auto* anchor = std::get_if<springs::AtAnchor>(&end))
      return {-1.0 - anchor->anchor, 0.0};
    const auto& on = std::get<springs::OnRod>(end);
    const geometry::ArcLength& rod = system.arc_lengths()[on.rod];
    const double s = rod.wrap(on.s);
    // Just below the seam is at it.
    const bool seam = rod.closed() && rod.length() - s < symmetry::same_place * rod.length();
    return {static_cast<double>(on.rod), seam ? 0.0 : s};
  };
  auto a = place(cable.a);
  auto b = place(cable.b);
  if (b < a) std::swap(a, b);
  return {a[0], a[1], b[0], b[1]};
}

// Whether the first of two is clearly before the second.
bool before(const std::array<double, 4>& a, const std::array<double, 4>& b) {
  for (std::size_t i = 0; i < 4; ++i)
    if (std::abs(a[i] - b[i]) > symmetry::same_place) return a[i] < b[i];
  return false;
}

Pull pull_of(const springs::Cable& cable, const equilibrium::System& system,
             const equilibrium::State& state) {
  Pull pull{.cable = cable,
            .stencil = springs::stencil(cable, system.arc_lengths(), system.structure().anchors)};
  const Eigen::Vector3d span = equilibrium::span_of(pull.stencil, state);
  pull.length = span.norm();
  pull.direction = span / pull.length;
  return pull;
}

// Rods' Hessian plus mass: the smallest mass from that of a free rod's softest motion on that makes
// it positive definite, so that H^-1 measures forces by the displacements they cause.
linalg::SymmetricFactor compliance(const equilibrium::System& system,
                                   const equilibrium::State& state) {
  constexpr double least_mass = 2000;  // in the unit of eigenvalues
  constexpr double most_mass = 1e15;
  linalg::SymmetricMatrix matrix = system.pattern();
  system.hessian(state, system.internal_forces(state), matrix);
  const Eigen::VectorXd mass = eigenvalue_unit(system) * lumped_mass(system);
  linalg::SymmetricFactor factor;
  for (double scale = least_mass; scale < most_mass; scale *= 4) {
    linalg::SymmetricMatrix heavier = matrix;
    for (int i = 0; i < heavier.cols(); ++i) heavier.coeffRef(i, i) += scale * mass[i];
    if (factor.factorise(heavier) && factor.inertia().negative == system.saddle_unknowns())
      return factor;
  }
  throw std::invalid_argument("balance: the rods' Hessian at the target is not finite");
}

}  // namespace

std::vector<Pulls> pulls_at(const equilibrium::System& system, const equilibrium::State& state,
                            std::span<const springs::Cable> candidates,
                            const symmetry::Group* symmetry) {
  std::vector<Pulls> pulls;
  for (const auto& cable : candidates) {
    if (!symmetry) {
      pulls.push_back({pull_of(cable, system, state)});
      continue;
    }
    const auto own = places_of(cable, system);
    const auto images = symmetry::orbit(cable, *symmetry);
    if (std::ranges::any_of(
            images, [&](const auto& image) { return before(places_of(image, system), own); }))
      continue;
    Pulls orbit;
    for (const auto& image : images) orbit.push_back(pull_of(image, system, state));
    pulls.push_back(std::move(orbit));
  }
  return pulls;
}

springs::Cable cable_of(const Pull& pull, double tension, double rho) {
  springs::Cable cable = pull.cable;
  cable.rest_length = rho * pull.length;
  cable.stiffness = tension / (pull.length - cable.rest_length);
  return cable;
}

Displacements displacements(const equilibrium::System& bare, const equilibrium::State& state,
                            const std::vector<Pulls>& pulls) {
  Eigen::MatrixXd forces =
      Eigen::MatrixXd::Zero(bare.size(), static_cast<Eigen::Index>(pulls.size()) + 1);
  for (Eigen::Index c = 0; c + 1 < forces.cols(); ++c)
    for (const Pull& pull : pulls[c])
      for_each_unknown(bare, pull, [&](int i, double weight) { forces(i, c) += weight; });
  forces.rightCols<1>() = -bare.rod_gradient(state);
  Eigen::MatrixXd moved = compliance(bare, state).solve(forces);
  const Eigen::VectorXd mass = lumped_mass(bare);
  for (Eigen::Index i = 0; i < moved.rows(); ++i)
    if (!(mass[i] > 0)) moved.row(i).setZero();
  return {.columns = moved.leftCols(forces.cols() - 1), .goal = moved.rightCols<1>()};
}

linalg::Nonnegative balance_forces(const equilibrium::System& bare, const equilibrium::State& state,
                                   const std::vector<Pulls>& pulls, double accuracy) {
  const linalg::SymmetricFactor factor = compliance(bare, state);
  Eigen::VectorXd positions = lumped_mass(bare);
  for (double& entry : positions) entry = entry > 0 ? 1.0 : 0.0;
  Eigen::VectorXd solution(bare.size());
  const auto displacement = [&](const Eigen::VectorXd& force) {
    factor.solve(force, solution);
    return Eigen::VectorXd(solution.cwiseProduct(positions));
  };
  const Eigen::VectorXd goal = displacement(-bare.rod_gradient(state));

  // What a unit of tension moves, for the candidates that were ever in the set.
  std::vector<Eigen::VectorXd> columns(pulls.size());
  const auto column = [&](int c) -> const Eigen::VectorXd& {
    if (columns[c].size() == 0) {
      Eigen::VectorXd force = Eigen::VectorXd::Zero(bare.size());
      for (const Pull& pull : pulls[c])
        for_each_unknown(bare, pull, [&](int i, double weight) { force[i] += weight; });
      columns[c] = displacement(force);
    }
    return columns[c];
  };
  const auto left_over = [&](std::span<const int> set, const Eigen::VectorXd& values) {
    Eigen::VectorXd rest = goal;
    for (std::size_t i = 0; i < set.size(); ++i)
      rest -= values[static_cast<Eigen::Index>(i)] * column(set[i]);
    return rest;
  };
  linalg::NonnegativeProblem problem{.size = static_cast<int>(pulls.size())};
  problem.slope = [&](std::span<const int> set, const Eigen::VectorXd& values,
                      Eigen::VectorXd& slope) {
    const Eigen::VectorXd back = displacement(left_over(set, values));
    slope.setZero(problem.size);
    for (int c = 0; c < problem.size; ++c)
      for (const Pull& pull : pulls[c])
        for_each_unknown(bare, pull, [&](int i, double weight) { slope[c] += weight * back[i]; });
  };
  problem.column = [&](std::span<const int> set, int j) {
    Eigen::VectorXd products(static_cast<Eigen::Index>(set.size()) + 1);
    for (std::size_t i = 0; i < set.size(); ++i)
      products[static_cast<Eigen::Index>(i)] = column(set[i]).dot(column(j));
    products[products.size() - 1] = column(j).squaredNorm();
    return products;
  };
  const auto& rods = bare.structure().rods;
  const auto small = [&](const Eigen::VectorXd& rest) {
    for (int r = 0; r < static_cast<int>(rods.size()); ++r)
      for (int v = 0; v < rods[r].vertices(); ++v) {
        double squared = 0;
        for (int axis = 0; axis < 3; ++axis)
          if (const int i = bare.position_index(r, v, axis); i >= 0) squared += rest[i] * rest[i];
        if (squared > accuracy * accuracy) return false;
      }
    return true;
  };
  if (small(goal)) return {.reason = linalg::NonnegativeReason::enough};
  problem.enough = [&](std::span<const int> set, const Eigen::VectorXd& values) {
    return small(left_over(set, values));
  };
  Eigen::VectorXd slope;
  problem.slope({}, {}, slope);
  if (!slope.allFinite()) return {.reason = linalg::NonnegativeReason::not_finite};
  return linalg::solve_nonnegative(problem, {.tolerance = 1e-9 * slope.cwiseAbs().maxCoeff()});
}

}  // namespace tencer::sparsify
