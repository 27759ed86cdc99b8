#include <cmath>
#include <numbers>
#include <tencer/certify/free_motions.hpp>
#include <tencer/certify/modes.hpp>
#include <tencer/model/material.hpp>
#include <tencer/model/units.hpp>

#include "check/pose.hpp"

namespace tencer::pipeline {
namespace {

// Where the shape is not known, that of a solid circle of the same stiffnesses: EI / EA = r^2 / 4.
double area_of(const der::Section& section) {
  return der::area(section.shape)
      .value_or(4 * std::numbers::pi * std::sqrt(section.EI1 * section.EI2) / section.EA);
}

}  // namespace

Eigen::VectorXd mass_per_length(const RestPose& pose) {
  const double metre = model::metres(pose.design.length_unit);
  const double newton = model::newtons(pose.design.force_unit) * pose.scaling.scale.force();
  const auto& rods = pose.design.structure.rods;
  Eigen::VectorXd mass(static_cast<Eigen::Index>(rods.size()));
  for (std::size_t r = 0; r < rods.size(); ++r) {
    const double density =
        material_of(pose.design, r).density.value_or(*model::glass_fibre().density);
    const double kilograms_per_metre = density * area_of(rods[r].section) * metre * metre;
    // kg / m = N s^2 / m^2.
    const double length = metre * pose.scaling.scale.length;
    mass[static_cast<Eigen::Index>(r)] = kilograms_per_metre * length * length / newton;
  }
  return mass;
}

model::Stands stands(const RestPose& pose, double moved) {
  const model::Certificate& certificate = *pose.design.certificate;
  const auto modes =
      certify::vibration_modes(pose.structure, pose.state, pose.tensions, mass_per_length(pose));
  constexpr double another_pose = 0.01;  // of the size
  model::Stands result{.moved = moved,
                       .allowed = another_pose * size_of(pose.design),
                       .residual = certificate.residual,
                       .smallest_eigenvalue = certificate.smallest_eigenvalue,
                       .slack_cables = certificate.slack_cables,
                       .certified = certificate.stable,
                       .hertz = {modes.hertz.begin(), modes.hertz.end()}};
  for (certify::FreeGroup group : certify::free_groups(pose.structure, pose.state)) {
    for (auto& motion : group.motions) motion.point = pose.scaling.unscaled(motion.point);
    result.free_groups.push_back(certify::describe(group, pose.structure.rods.size()));
  }
  return result;
}

}  // namespace tencer::pipeline
