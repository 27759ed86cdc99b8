// From the units of a scene to those in which problems are solved, and back.
#pragma once

#include <Eigen/Core>
#include <tencer/core/scale.hpp>
#include <tencer/model/rules.hpp>
#include <tencer/model/structure.hpp>
#include <vector>

namespace tencer::model {

// Scaled coordinates are (coordinates - origin) / scale.length: the rods' total length is 1 and the
// largest EI / length is 1, whatever the scene's units.
struct Scaling {
  core::Scale scale{};
  Eigen::Vector3d origin = Eigen::Vector3d::Zero();

  Eigen::Matrix3Xd scaled(const Eigen::Matrix3Xd& points) const {
    return (points.colwise() - origin) / scale.length;
  }
  Eigen::Matrix3Xd unscaled(const Eigen::Matrix3Xd& points) const {
    return (points * scale.length).colwise() + origin;
  }
};

// The scaling of rods whose vertices are about `points` (3 x n per rod), their mean at the origin.
Scaling scaling_of(const Structure& structure, const std::vector<Eigen::Matrix3Xd>& points);

std::vector<Eigen::Matrix3Xd> scaled(const std::vector<Eigen::Matrix3Xd>& points,
                                     const Scaling& scaling);
Structure scaled(const Structure& structure, const Scaling& scaling);
Rules scaled(Rules rules, const Scaling& scaling);

// A cable of the scaled structure in the scene's units, its arc lengths wrapped into [0, length of
// the rod].
springs::Cable unscaled(springs::Cable cable, const Structure& scaled, const Scaling& scaling);

}  // namespace tencer::model
