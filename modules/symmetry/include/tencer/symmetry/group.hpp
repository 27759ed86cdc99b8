// A finite group of symmetry operations.
#pragma once

#include <Eigen/Core>
#include <span>
#include <tencer/core/error.hpp>
#include <tencer/geometry/arc_length.hpp>
#include <tencer/symmetry/operation.hpp>
#include <vector>

namespace tencer::symmetry {

// operations[0] is the identity. product(g, h): the index of operation h followed by g. rods: the
// arc lengths at rest on which the operations act.
struct Group {
  std::vector<geometry::ArcLength> rods{};
  std::vector<Operation> operations{};
  Eigen::MatrixXi product{};

  int order() const { return static_cast<int>(operations.size()); }
};

// All products of the generators. Generators that were measured, and so are a little off, are moved
// onto the nearest operations that obey the group's multiplication table to rounding (by averaging:
// the matrices over g h h^-1 for all h, the offsets likewise), with a common fixed point. Error
// when there are more than max_order operations: the axes and planes do not belong to one finite
// group.
core::Expected<Group> closure(std::span<const Operation> generators,
                              std::vector<geometry::ArcLength> rods, int anchors,
                              int max_order = 240);

}  // namespace tencer::symmetry
