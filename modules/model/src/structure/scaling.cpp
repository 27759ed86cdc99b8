#include <algorithm>
#include <tencer/geometry/arc_length.hpp>
#include <tencer/model/scaling.hpp>

namespace tencer::model {
namespace {

der::Rod scaled(der::Rod rod, const core::Scale& scale) {
  rod.section = {.EA = rod.section.EA / scale.force(),
                 .EI1 = rod.section.EI1 / scale.bending(),
                 .EI2 = rod.section.EI2 / scale.bending(),
                 .GJ = rod.section.GJ / scale.bending(),
                 .shape = der::resized(rod.section.shape, 1 / scale.length)};
  rod.rest_lengths /= scale.length;
  return rod;
}

springs::End scaled(springs::End end, const core::Scale& scale) {
  if (auto* on = std::get_if<springs::OnRod>(&end)) on->s /= scale.length;
  return end;
}

springs::Cable scaled(const springs::Cable& cable, const core::Scale& scale) {
  return {.a = scaled(cable.a, scale),
          .b = scaled(cable.b, scale),
          .stiffness = cable.stiffness / scale.stiffness(),
          .rest_length = cable.rest_length / scale.length,
          .tension_only = cable.tension_only};
}

}  // namespace

Scaling scaling_of(const Structure& structure, const std::vector<Eigen::Matrix3Xd>& points) {
  double bending = 0;
  for (const auto& rod : structure.rods)
    bending = std::max({bending, rod.section.EI1, rod.section.EI2});
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  Eigen::Index vertices = 0;
  for (const auto& rod : points) {
    sum += rod.rowwise().sum();
    vertices += rod.cols();
  }
  const double length = total_length(structure);
  return {.scale = {.length = length, .energy = bending / length},
          .origin = sum / static_cast<double>(vertices)};
}

std::vector<Eigen::Matrix3Xd> scaled(const std::vector<Eigen::Matrix3Xd>& points,
                                     const Scaling& scaling) {
  std::vector<Eigen::Matrix3Xd> result;
  for (const auto& rod : points) result.push_back(scaling.scaled(rod));
  return result;
}

Structure scaled(const Structure& structure, const Scaling& scaling) {
  const core::Scale& scale = scaling.scale;
  Structure result = structure;
  for (auto& rod : result.rods) rod = scaled(std::move(rod), scale);
  result.anchors = scaling.scaled(structure.anchors);
  for (auto& cable : result.cables) cable = scaled(cable, scale);
  for (auto& load : result.point_loads) {
    load.s /= scale.length;
    load.force /= scale.force();
  }
  for (auto& load : result.line_loads) load.force_per_length *= scale.length / scale.force();
  return result;
}

Rules scaled(Rules rules, const Scaling& scaling) {
  for (Arc& arc : rules.forbidden) {
    arc.from /= scaling.scale.length;
    arc.to /= scaling.scale.length;
  }
  for (auto& cable : rules.unwanted) cable = scaled(cable, scaling.scale);
  rules.max_cable_length /= scaling.scale.length;
  if (rules.gaps) {
    if (rules.gaps->clearance) *rules.gaps->clearance /= scaling.scale.length;
    if (rules.gaps->mark_distance) *rules.gaps->mark_distance /= scaling.scale.length;
  }
  return rules;
}

springs::Cable unscaled(springs::Cable cable, const Structure& scaled, const Scaling& scaling) {
  const core::Scale& scale = scaling.scale;
  for (springs::End* end : {&cable.a, &cable.b})
    if (auto* on = std::get_if<springs::OnRod>(end)) {
      const der::Rod& rod = scaled.rods[on->rod];
      on->s = geometry::ArcLength(rod.rest_lengths, rod.closed).wrap(on->s) * scale.length;
    }
  cable.stiffness *= scale.stiffness();
  cable.rest_length *= scale.length;
  return cable;
}

}  // namespace tencer::model
