// How far bends strain rods: the outer fibres of their sections at a pose.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <tencer/model/state.hpp>
#include <tencer/model/structure.hpp>
#include <vector>

namespace tencer::model {

// The largest bending strain of a rod: a fraction, at a vertex and its arc length at rest.
struct BendingStrain {
  double strain = 0.0;
  double curvature = 0.0;  // there, beyond that at rest, 1 / length
  int vertex = 0;
  double s = 0.0;
};

// One entry a rod; not set where the section has no shape. A rod without bending vertices has no
// strain.
std::vector<std::optional<BendingStrain>> largest_bending_strains(const Structure& structure,
                                                                  const State& state);

// The strain of a structure whose lengths are multiples of `unit`, in whose terms `scaled` is.
BendingStrain unscaled(BendingStrain scaled, double unit);

// Why a rod cannot be bent so, and what would do: its target has corners, or is rough; else its
// largest strain breaks its material. Not set when nothing is wrong, or not known. target: 3 x n;
// rods that are bent at rest may have corners.
std::optional<std::string> bend_problem(const Structure& structure, std::size_t rod,
                                        const Eigen::Matrix3Xd& target,
                                        const std::optional<BendingStrain>& largest,
                                        std::string_view length_unit);

// What its builder should know of a rod's bends: that, or a strain that its material does not hold
// for long.
std::optional<std::string> bend_warning(const Structure& structure, std::size_t rod,
                                        const Eigen::Matrix3Xd& target,
                                        const std::optional<BendingStrain>& largest,
                                        std::string_view length_unit);

}  // namespace tencer::model
