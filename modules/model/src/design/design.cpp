#include <algorithm>
#include <tencer/model/design.hpp>
#include <tencer/springs/law.hpp>

namespace tencer::model {

namespace {

Footing footing_of(const Design& design) {
  if (!design.certificate || !design.certificate->stable ||
      !design.certificate->settles_from_target.value_or(false))
    return Footing::none;
  if (!design.check || shortfalls(*design.check, {design.length_unit, design.force_unit}).empty())
    return Footing::stands;
  const auto& forgives = design.check->forgives;
  return forgives && forgives->fallen == 0 ? Footing::keeps : Footing::none;
}

}  // namespace

Score score_of(const Design& design) {
  return {.cables = static_cast<int>(design.structure.cables.size()),
          .max_percent = design.error->max_percent,
          .footing = footing_of(design)};
}

int external_cables(const Design& design) {
  return static_cast<int>(std::ranges::count_if(design.structure.cables, is_external));
}

geometry::Polyline pose_curve(const Design& design, std::size_t rod) {
  return {design.pose[rod], design.structure.rods[rod].closed};
}

Structure as_built(const Design& design) {
  Structure structure = design.structure;
  for (std::size_t c = 0; c < structure.cables.size(); ++c) {
    structure.cables[c].stiffness = 0;
    structure.cables[c].rest_length = design.built[c].length;
  }
  return structure;
}

std::vector<BuiltCable> built_in_pose(const Structure& structure,
                                      const std::vector<Eigen::Matrix3Xd>& pose) {
  const auto along = arc_lengths(structure);
  std::vector<BuiltCable> built;
  for (const springs::Cable& cable : structure.cables) {
    const auto stencil = springs::stencil(cable, along, structure.anchors);
    const double length = springs::span_of(stencil, [&](int rod, int vertex) -> Eigen::Vector3d {
                            return pose[rod].col(vertex);
                          }).norm();
    built.push_back({.length = length, .tension = springs::tension(cable, length)});
  }
  return built;
}

}  // namespace tencer::model
