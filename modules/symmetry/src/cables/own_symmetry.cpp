#include "cables/own_symmetry.hpp"

#include <algorithm>
#include <cmath>
#include <tencer/core/error.hpp>
#include <vector>

#include "cables/cable_index.hpp"

namespace tencer::symmetry {
namespace {

// Operations under which the cable is its own image, as it is or with its ends swapped.
struct Keeper {
  int operation = 0;
  bool swapped = false;
};

std::vector<Keeper> keepers(const springs::Cable& cable, const Group& group, double tolerance) {
  std::vector<Keeper> result;
  for (int g = 0; g < group.order(); ++g) {
    const springs::Cable moved = image(group.operations[g], cable, group.rods);
    const auto furthest = [&](const springs::End& a, const springs::End& b) {
      return std::max(apart(moved.a, a, group.rods), apart(moved.b, b, group.rods));
    };
    const double straight = furthest(cable.a, cable.b);
    const double swapped = furthest(cable.b, cable.a);
    if (std::min(straight, swapped) <= tolerance) result.push_back({g, swapped < straight});
  }
  return result;
}

}  // namespace

void validate(const springs::Cable& cable, const Group& group) {
  core::require(group.order() > 0, "symmetry: a group needs at least the identity");
  springs::validate(cable, static_cast<int>(group.rods.size()),
                    static_cast<int>(group.operations[0].anchors.size()));
}

double position(const springs::End& end) {
  const auto* on_rod = std::get_if<springs::OnRod>(&end);
  return on_rod ? on_rod->s : 0.0;
}

Follows follows(const Operation& operation, const springs::OnRod& source, double near,
                const Group& group) {
  const RodMap& map = operation.rods[source.rod];
  const geometry::ArcLength& target = group.rods[map.rod];
  Follows result{map.rate, map.offset};
  if (target.closed()) {
    const double length = target.length();
    result.offset += length * std::round((near - map.rate * source.s - map.offset) / length);
  }
  return result;
}

OwnSymmetry own_symmetry(const springs::Cable& cable, const Group& group, double tolerance) {
  const std::array<springs::End, 2> ends{cable.a, cable.b};
  const Eigen::Vector2d own(position(cable.a), position(cable.b));
  // The mean of the images under the keepers is kept by all of them: positions are fixed points of
  // x -> mean * x + shift, which is a projection.
  Eigen::Matrix2d mean = Eigen::Matrix2d::Zero();
  Eigen::Vector2d shift = Eigen::Vector2d::Zero();
  const std::vector<Keeper> kept = keepers(cable, group, tolerance);
  for (const Keeper& keeper : kept) {
    for (int end = 0; end < 2; ++end) {
      const int source = keeper.swapped ? 1 - end : end;
      const auto* on_rod = std::get_if<springs::OnRod>(&ends[source]);
      if (!on_rod) continue;
      const Follows map = follows(group.operations[keeper.operation], *on_rod, own[end], group);
      mean(end, source) += map.slope;
      shift[end] += map.offset;
    }
  }
  mean /= static_cast<double>(kept.size());
  shift /= static_cast<double>(kept.size());

  OwnSymmetry result{.cable = cable};
  const Eigen::Vector2d kept_position = mean * own + shift;
  result.fixed = kept_position;
  const auto rank = std::lround(mean.trace());
  if (rank == 2) {
    result.free = {true, true};
    result.slopes.setIdentity();
    result.fixed.setZero();
  } else if (rank == 1) {
    // One free position: end a's unless that is held.
    const int end = mean(0, 0) > 0.25 ? 0 : 1;
    result.free[end] = true;
    result.slopes.col(end) = mean.col(end) / mean(end, end);
    result.fixed -= result.slopes.col(end) * kept_position[end];
  }
  const auto move = [&](springs::End& end, double s) {
    if (auto* on_rod = std::get_if<springs::OnRod>(&end)) on_rod->s = s;
  };
  move(result.cable.a, kept_position[0]);
  move(result.cable.b, kept_position[1]);
  return result;
}

}  // namespace tencer::symmetry
