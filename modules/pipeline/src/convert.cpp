#include <algorithm>
#include <tencer/core/error.hpp>
#include <tencer/der/energy.hpp>
#include <tencer/pipeline/convert.hpp>

#include "frames.hpp"
#include "units_sum.hpp"

namespace tencer::pipeline {
namespace {

springs::End end_of(const io::CableEnd& end, const Units& units) {
  if (end.anchor >= 0) return springs::AtAnchor{end.anchor};
  return springs::OnRod{end.rod, end.s / units.scale.length};
}

std::vector<Eigen::Matrix3Xd> scaled(const io::Design& design, const Units& units,
                                     Eigen::Matrix3Xd io::DesignRod::*points) {
  std::vector<Eigen::Matrix3Xd> all;
  for (const auto& rod : design.rods) all.push_back(units.scaled(rod.*points));
  return all;
}

}  // namespace

Units units_of(const io::Design& design) {
  UnitsSum sum;
  for (const auto& rod : design.rods) sum.add(rod.length(), rod.EI.maxCoeff(), rod.target);
  return sum.units();
}

equilibrium::Structure structure_of(const io::Design& design, Cables cables, const Units& units) {
  const core::Scale& scale = units.scale;
  equilibrium::Structure structure;
  for (const auto& from : design.rods) {
    der::Rod rod;
    rod.closed = from.closed;
    rod.section = {.EA = from.EA / scale.force(),
                   .EI1 = from.EI[0] / scale.bending(),
                   .EI2 = from.EI[1] / scale.bending(),
                   .GJ = from.GJ / scale.bending()};
    rod.rest_lengths = from.rest_lengths / scale.length;
    rod.rest_curvature = from.rest_curvature;
    rod.rest_twist = from.rest_twist;
    rod.closing_angle = from.closing_angle;
    structure.rods.push_back(rod);
  }
  structure.anchors = units.scaled(design.anchors);
  for (const io::Pin& pin : design.pinned)
    structure.pins.push_back({.rod = pin.rod, .vertex = pin.vertex, .axes = pin.axes});
  for (const io::PointLoad& load : design.point_loads)
    structure.point_loads.push_back(
        {.rod = load.rod, .s = load.s / scale.length, .force = load.force / scale.force()});
  for (const io::LineLoad& load : design.line_loads)
    structure.line_loads.push_back(
        {.rod = load.rod,
         .force_per_length = load.force_per_length * (scale.length / scale.force())});
  structure.planar = design.planar;
  for (const auto& from : design.cables) {
    springs::Cable cable{.a = end_of(from.a, units), .b = end_of(from.b, units)};
    if (cables == Cables::springs) {
      core::require(from.stiffness && from.rest_length, "structure_of: a cable has no stiffness");
      cable.stiffness = *from.stiffness / scale.stiffness();
      cable.rest_length = *from.rest_length / scale.length;
    } else {
      cable.rest_length = from.length / scale.length;
    }
    structure.cables.push_back(cable);
  }
  return structure;
}

std::vector<Eigen::Matrix3Xd> scaled_targets(const io::Design& design, const Units& units) {
  return scaled(design, units, &io::DesignRod::target);
}

std::vector<Eigen::Matrix3Xd> scaled_poses(const io::Design& design, const Units& units) {
  return scaled(design, units, &io::DesignRod::pose);
}

equilibrium::State target_state(const io::Design& design, const equilibrium::Structure& structure,
                                const Units& units) {
  equilibrium::State state = make_state(structure, scaled_targets(design, units));
  bool unknown = false;
  for (std::size_t r = 0; r < state.size(); ++r) {
    if (design.rods[r].target_directors.cols() > 0) {
      set_frames(state[r], design.rods[r].target_directors);
    } else {
      turn_to_least_energy(structure.rods[r], state[r]);
      unknown = true;
    }
  }
  if (unknown) settle_frames(structure, state);
  return state;
}

equilibrium::State pose_state(const io::Design& design, const equilibrium::Structure& structure,
                              const Units& units) {
  const auto poses = scaled_poses(design, units);
  equilibrium::State state = make_state(structure, poses);
  const auto twists = [](const der::Rod& rod) {
    return der::twist_model(rod) != der::TwistModel::none;
  };
  if (std::ranges::none_of(structure.rods, twists)) return state;
  equilibrium::State carried = target_state(design, structure, units);
  for (std::size_t r = 0; r < state.size(); ++r) {
    const der::Rod& rod = structure.rods[r];
    if (!twists(rod)) continue;
    Eigen::VectorXd step = Eigen::VectorXd::Zero(der::unknowns(rod));
    step.head(poses[r].size()) = (poses[r] - carried[r].x).reshaped();
    der::displace(rod, carried[r], step);
    if (design.rods[r].pose_directors.cols() > 0)
      set_frames(carried[r], design.rods[r].pose_directors);
    state[r] = carried[r];
  }
  return state;
}

io::CableEnd file_end(const springs::End& end, const equilibrium::Structure& structure,
                      const Units& units) {
  if (const auto* anchor = std::get_if<springs::AtAnchor>(&end)) return {.anchor = anchor->anchor};
  const auto& on_rod = std::get<springs::OnRod>(end);
  const auto& rod = structure.rods[on_rod.rod];
  const geometry::ArcLength arc(rod.rest_lengths, rod.closed);
  return {.rod = on_rod.rod, .s = arc.wrap(on_rod.s) * units.scale.length};
}

}  // namespace tencer::pipeline
