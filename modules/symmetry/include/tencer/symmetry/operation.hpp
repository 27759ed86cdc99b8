// A symmetry operation: a rigid map of space, proper or not, and what it does to rods, anchors and
// cables (paper section 5.3, "Symmetry constraints").
#pragma once

#include <Eigen/Core>
#include <span>
#include <tencer/geometry/arc_length.hpp>
#include <tencer/springs/cable.hpp>
#include <vector>

namespace tencer::symmetry {

// The point s of a rod goes to the point rate * s + offset of the rod `rod`, both measured at rest.
// rate: +1 or -1 times the image's length over the rod's own, so that closed rods wrap alike.
// offset: in [0, length of the image) on closed rods; 0 or that length on open ones.
struct RodMap {
  int rod = 0;
  double rate = 1.0;
  double offset = 0.0;
};

// x -> matrix * x + translation, matrix orthogonal (determinant -1: a reflection or a rotation with
// one); rods[r] says where rod r goes, anchors[i] which anchor i becomes. Both are permutations.
struct Operation {
  Eigen::Matrix3d matrix = Eigen::Matrix3d::Identity();
  Eigen::Vector3d translation = Eigen::Vector3d::Zero();
  std::vector<RodMap> rods{};
  std::vector<int> anchors{};
};

Operation identity(int rods, int anchors);

// `first`, then `second`. rods: the rods' arc lengths at rest, here and below.
Operation compose(const Operation& second, const Operation& first,
                  std::span<const geometry::ArcLength> rods);

// The place that an end goes to, wrapped. Throws std::invalid_argument for a rod or an anchor that
// does not exist.
springs::End image(const Operation& operation, const springs::End& end,
                   std::span<const geometry::ArcLength> rods);

// The cable with the images of the two ends, otherwise as it is.
springs::Cable image(const Operation& operation, const springs::Cable& cable,
                     std::span<const geometry::ArcLength> rods);

}  // namespace tencer::symmetry
