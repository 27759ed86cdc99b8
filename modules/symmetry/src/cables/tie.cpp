#include <array>
#include <tencer/core/error.hpp>
#include <tencer/symmetry/tie.hpp>

#include "cables/cable_index.hpp"
#include "cables/own_symmetry.hpp"

namespace tencer::symmetry {
namespace {

using springs::ParameterKind;

constexpr std::array positions{ParameterKind::position_a, ParameterKind::position_b};

struct Orbit {
  OwnSymmetry first;
  int strength = 0;                     // its column
  std::array<int, 2> position{-1, -1};  // the columns of its free positions
};

Orbit start_orbit(Ties& ties, int cable, ParameterKind strength, OwnSymmetry first) {
  const auto add = [&](ParameterKind kind) {
    ties.free.push_back({kind, cable});
    return static_cast<int>(ties.free.size()) - 1;
  };
  Orbit orbit{.first = std::move(first), .strength = add(strength)};
  for (int end = 0; end < 2; ++end)
    if (orbit.first.free[end]) orbit.position[end] = add(positions[end]);
  return orbit;
}

}  // namespace

Ties tie_cables(std::span<const springs::Cable> cables, const Group& group, ParameterKind strength,
                double tolerance) {
  core::require(strength == ParameterKind::stiffness || strength == ParameterKind::rest_length,
                "tie_cables: the strength is a stiffness or a rest length");
  for (const springs::Cable& cable : cables) validate(cable, group);
  Ties ties;
  std::vector<Orbit> orbits;
  std::vector<Eigen::Triplet<double>> entries;
  std::vector<double> offset;
  // Values: orbit * order + operation.
  CableIndex index(group.rods, tolerance);
  for (int i = 0; i < static_cast<int>(cables.size()); ++i) {
    auto found = index.find(cables[i]);
    if (!found) {
      const int number = static_cast<int>(orbits.size());
      orbits.push_back(start_orbit(ties, i, strength, own_symmetry(cables[i], group, tolerance)));
      const springs::Cable& first = orbits.back().first.cable;
      for (int g = 0; g < group.order(); ++g)
        index.add(image(group.operations[g], first, group.rods), number * group.order() + g);
      found = CableIndex::Found{number * group.order(), false};
    }
    const Orbit& orbit = orbits[found->value / group.order()];
    const Operation& operation = group.operations[found->value % group.order()];
    ties.orbit.push_back(found->value / group.order());
    const auto add_row = [&](ParameterKind kind) {
      ties.parameters.push_back({kind, i});
      offset.push_back(0.0);
      return static_cast<int>(offset.size()) - 1;
    };
    entries.emplace_back(add_row(strength), orbit.strength, 1.0);
    const std::array<springs::End, 2> own{cables[i].a, cables[i].b};
    const std::array<springs::End, 2> first{orbit.first.cable.a, orbit.first.cable.b};
    for (int end = 0; end < 2; ++end) {
      if (!std::holds_alternative<springs::OnRod>(own[end])) continue;
      const int source = found->swapped ? 1 - end : end;
      const Follows map =
          follows(operation, std::get<springs::OnRod>(first[source]), position(own[end]), group);
      const int row = add_row(positions[end]);
      offset[row] = map.slope * orbit.first.fixed[source] + map.offset;
      for (int free = 0; free < 2; ++free)
        if (const double slope = orbit.first.slopes(source, free); slope != 0.0)
          entries.emplace_back(row, orbit.position[free], map.slope * slope);
    }
  }
  ties.offset = Eigen::Map<const Eigen::VectorXd>(offset.data(), std::ssize(offset));
  ties.matrix.resize(std::ssize(offset), std::ssize(ties.free));
  ties.matrix.setFromTriplets(entries.begin(), entries.end());
  return ties;
}

Eigen::VectorXd project(const Ties& ties, const Eigen::VectorXd& p) {
  core::require(p.size() == ties.offset.size(), "project: one value for each parameter");
  // One entry in a row: the columns are orthogonal.
  const Eigen::VectorXd right = ties.matrix.transpose() * (p - ties.offset);
  Eigen::VectorXd squares(ties.matrix.cols());
  for (int j = 0; j < ties.matrix.cols(); ++j) squares[j] = ties.matrix.col(j).squaredNorm();
  return right.cwiseQuotient(squares);
}

}  // namespace tencer::symmetry
