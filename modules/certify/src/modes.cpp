#include <algorithm>
#include <cmath>
#include <numbers>
#include <tencer/certify/modes.hpp>
#include <tencer/core/error.hpp>
#include <tencer/equilibrium/constrained.hpp>
#include <tencer/equilibrium/modal.hpp>

namespace tencer::certify {
namespace {

using equilibrium::System;

std::vector<Eigen::Matrix3Xd> shape_of(const System& system, const Eigen::VectorXd& motion) {
  std::vector<Eigen::Matrix3Xd> shape;
  const auto& rods = system.structure().rods;
  for (int r = 0; r < static_cast<int>(rods.size()); ++r) {
    auto& moved = shape.emplace_back(Eigen::Matrix3Xd::Zero(3, rods[r].vertices()));
    for (int v = 0; v < rods[r].vertices(); ++v)
      for (int axis = 0; axis < 3; ++axis)
        if (const int at = system.position_index(r, v, axis); at >= 0) moved(axis, v) = motion[at];
  }
  return shape;
}

}  // namespace

VibrationModes vibration_modes(const model::Structure& structure, const model::State& state,
                               const Eigen::VectorXd& tensions,
                               const Eigen::VectorXd& mass_per_length, int count) {
  core::require(mass_per_length.size() == static_cast<Eigen::Index>(structure.rods.size()) &&
                    (mass_per_length.array() > 0).all() && mass_per_length.allFinite(),
                "vibration_modes: needs a positive mass per length for every rod");
  core::require(count >= 1, "vibration_modes: needs count >= 1");
  const System system =
      equilibrium::taut_system(structure, state, tensions, equilibrium::taut_cables(tensions));
  const Eigen::VectorXd mass = equilibrium::lumped_mass(system, mass_per_length);
  equilibrium::ConstrainedHessian hessian(system, state,
                                          equilibrium::length_gradients(system, state), mass);
  if (!hessian.factorise()) return {};
  const double unit = equilibrium::eigenvalue_unit(structure) / mass_per_length.maxCoeff();
  for (double shift = unit; hessian.negative() > 0; shift *= 10)
    if (!hessian.factorise(shift) || !std::isfinite(shift)) return {};
  const auto modes = hessian.lowest(count);
  if (!modes.converged) return {};
  VibrationModes result{.hertz = modes.values.cwiseMax(0).cwiseSqrt() / (2 * std::numbers::pi),
                        .computed = true};
  for (const auto& motion : modes.motions.colwise())
    result.shapes.push_back(shape_of(system, motion));
  return result;
}

}  // namespace tencer::certify
