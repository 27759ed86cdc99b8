// What the operations that map a cable onto itself leave of its freedom to slide.
#pragma once

#include <Eigen/Core>
#include <array>
#include <tencer/springs/cable.hpp>
#include <tencer/symmetry/group.hpp>

namespace tencer::symmetry {

// Throws as springs::validate does unless the cable refers to the group's rods and anchors.
void validate(const springs::Cable& cable, const Group& group);

// The arc length s of an end, or 0 of an anchored one.
double position(const springs::End& end);

// The cable's positions are slopes * z + fixed, both ends (a, b); z are its own positions where
// free[end]. cable: moved to the nearest positions of that form.
struct OwnSymmetry {
  springs::Cable cable{};
  std::array<bool, 2> free{};
  Eigen::Matrix2d slopes = Eigen::Matrix2d::Zero();
  Eigen::Vector2d fixed = Eigen::Vector2d::Zero();
};

OwnSymmetry own_symmetry(const springs::Cable& cable, const Group& group, double tolerance);

// How end b's or a's position follows from another's: slope * s + offset, with the multiple of a
// closed rod's length that brings it nearest to `near`.
struct Follows {
  double slope = 1.0;
  double offset = 0.0;
};
Follows follows(const Operation& operation, const springs::OnRod& source, double near,
                const Group& group);

}  // namespace tencer::symmetry
