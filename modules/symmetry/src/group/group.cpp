#include <Eigen/SVD>
#include <algorithm>
#include <cmath>
#include <string>
#include <tencer/symmetry/group.hpp>

#include "detection/same_operation.hpp"

namespace tencer::symmetry {
namespace {

int find(const std::vector<Operation>& operations, const Operation& wanted,
         std::span<const geometry::ArcLength> rods) {
  for (std::size_t i = 0; i < operations.size(); ++i)
    if (same_operation(operations[i], wanted, rods)) return static_cast<int>(i);
  return -1;
}

Eigen::Matrix3d nearest_orthogonal(const Eigen::Matrix3d& matrix) {
  const Eigen::JacobiSVD<Eigen::Matrix3d> svd(matrix, Eigen::ComputeFullU | Eigen::ComputeFullV);
  return svd.matrixU() * svd.matrixV().transpose();
}

// The matrices as g h h^-1 averaged over h: the defect is squared by each round.
void average_matrices(Group& group) {
  const int order = group.order();
  for (int round = 0; round < 4; ++round) {
    std::vector<Eigen::Matrix3d> better;
    for (int g = 0; g < order; ++g) {
      Eigen::Matrix3d sum = Eigen::Matrix3d::Zero();
      for (int h = 0; h < order; ++h)
        sum +=
            group.operations[group.product(g, h)].matrix * group.operations[h].matrix.transpose();
      better.push_back(nearest_orthogonal(sum));
    }
    for (int g = 0; g < order; ++g) group.operations[g].matrix = better[g];
  }
  group.operations[0].matrix.setIdentity();
}

// The mean of an orbit is a point that all operations keep.
void fix_common_point(Group& group) {
  Eigen::Vector3d point = Eigen::Vector3d::Zero();
  for (const Operation& operation : group.operations) point += operation.translation;
  point /= group.order();
  for (Operation& operation : group.operations)
    operation.translation = point - operation.matrix * point;
}

// The offsets on closed rods as g h h^-1 averaged over h, which is exact after one round, since
// offsets add.
void average_offsets(Group& group) {
  const std::vector<Operation> measured = group.operations;
  const int order = group.order();
  for (int g = 0; g < order; ++g) {
    for (std::size_t r = 0; r < group.rods.size(); ++r) {
      RodMap& map = group.operations[g].rods[r];
      const geometry::ArcLength& target = group.rods[map.rod];
      if (!target.closed()) continue;
      double correction = 0.0;
      for (int h = 0; h < order; ++h) {
        // The rod that h brings to r, and where g h brings it.
        std::size_t from = 0;
        while (measured[h].rods[from].rod != static_cast<int>(r)) ++from;
        const RodMap& whole = measured[group.product(g, h)].rods[from];
        const double offset = whole.offset - map.rate * measured[h].rods[from].offset;
        correction += std::remainder(offset - measured[g].rods[r].offset, target.length());
      }
      map.offset = target.wrap(measured[g].rods[r].offset + correction / order);
    }
  }
}

}  // namespace

bool same_operation(const Operation& a, const Operation& b,
                    std::span<const geometry::ArcLength> rods) {
  // Operations of a finite group of a few hundred differ by far more than measuring errors.
  constexpr double slack = 1e-2;
  if ((a.matrix - b.matrix).norm() > slack || a.anchors != b.anchors) return false;
  double longest = 0.0;
  for (std::size_t r = 0; r < rods.size(); ++r) {
    const RodMap& map = a.rods[r];
    const RodMap& other = b.rods[r];
    if (map.rod != other.rod || std::signbit(map.rate) != std::signbit(other.rate)) return false;
    const double length = rods[map.rod].length();
    if (rods[map.rod].closed() &&
        std::abs(std::remainder(map.offset - other.offset, length)) > slack * length)
      return false;
    longest = std::max(longest, length);
  }
  return (a.translation - b.translation).norm() <= slack * longest;
}

core::Expected<Group> closure(std::span<const Operation> generators,
                              std::vector<geometry::ArcLength> rods, int anchors, int max_order) {
  core::require(max_order >= 1, "closure: max_order must be positive");
  Group group{.rods = std::move(rods), .operations = {}, .product = {}};
  group.operations.push_back(identity(static_cast<int>(group.rods.size()), anchors));
  const core::Error open{
      "symmetry", "the rotations and reflections make more than " + std::to_string(max_order) +
                      " different operations; let their axes and planes meet in one point, at "
                      "angles that fit their folds"};
  for (std::size_t i = 0; i < group.operations.size(); ++i) {
    for (const Operation& generator : generators) {
      Operation next = compose(generator, group.operations[i], group.rods);
      if (find(group.operations, next, group.rods) >= 0) continue;
      if (group.order() == max_order) return open;
      group.operations.push_back(std::move(next));
    }
  }
  group.product.resize(group.order(), group.order());
  for (int g = 0; g < group.order(); ++g) {
    for (int h = 0; h < group.order(); ++h) {
      const int product =
          find(group.operations, compose(group.operations[g], group.operations[h], group.rods),
               group.rods);
      if (product < 0) return open;
      group.product(g, h) = product;
    }
  }
  average_matrices(group);
  fix_common_point(group);
  average_offsets(group);
  return group;
}

}  // namespace tencer::symmetry
