// What a drawing shows along the rods of a design, a value a vertex: how far the pose is from the
// target, and what bending and pulling do to the rod there.
#pragma once

#include <Eigen/Core>
#include <optional>
#include <tencer/model/design.hpp>
#include <vector>

namespace tencer::model {

// Of a rod with n vertices. Vertices at which nothing bends, the ends of an open rod, have no
// curvature and no strain.
struct VertexFields {
  Eigen::Matrix3Xd deviation{};  // 3 x n: from the target to the pose, a length
  Eigen::VectorXd curvature{};   // n: of the pose, 1 / length
  // n: of the outer fibres, a fraction, beyond what the rod has at rest. Not set: the section has
  // no shape, or it matters how it is turned and the design does not say.
  std::optional<Eigen::VectorXd> strain = std::nullopt;
  Eigen::VectorXd tension{};  // n: along the rod, the mean of the edges that meet there, a force
};

// One entry a rod, in the design's units.
std::vector<VertexFields> vertex_fields(const Design& design);

}  // namespace tencer::model
