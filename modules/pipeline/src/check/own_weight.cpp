#include <algorithm>
#include <tencer/certify/own_weight.hpp>
#include <tencer/model/units.hpp>

#include "check/pose.hpp"

namespace tencer::pipeline {
namespace {

std::optional<model::Sag> told(const certify::Sag& sag, const RestPose& pose) {
  if (!sag.computed) return std::nullopt;
  model::Sag result{.deviation = sag.deviation * pose.scaling.scale.length,
                    .settled = sag.settled,
                    .falls = sag.falls};
  const auto along = model::arc_lengths(pose.design.structure);
  for (const auto& [rod, vertex] : sag.at)
    result.at.push_back({.rod = rod, .vertex = vertex, .s = along[rod].knots()[vertex]});
  return result;
}

}  // namespace

model::OwnWeight own_weight(const RestPose& pose, const CheckOptions& options) {
  constexpr double gravity = 9.81;  // m/s^2
  if (!pose.structure.line_loads.empty()) return {.included = true};
  // Masses are in force s^2 / length^2, so the acceleration is in lengths.
  const double metre = model::metres(pose.design.length_unit) * pose.scaling.scale.length;
  const Eigen::VectorXd weight = gravity / metre * mass_per_length(pose);
  // Altogether about as many as it takes to find a good one, whatever the number of rods.
  const int tries = std::clamp(96 / static_cast<int>(pose.structure.rods.size()), 2, 24);
  model::OwnWeight result;
  const certify::Sag hung = certify::own_weight_sag(pose.structure, pose.state, pose.tensions,
                                                    weight, tries, options.stop);
  result.hung = told(hung, pose);
  result.held = hung.computed && hung.at.empty();
  if (!hung.computed || result.held || pose.structure.planar) return result;
  if (const auto stance = certify::stance(pose.structure, pose.state, weight))
    result.standing = told(certify::standing_sag(pose.structure, pose.state, pose.tensions, weight,
                                                 *stance, options.stop),
                           pose);
  return result;
}

}  // namespace tencer::pipeline
