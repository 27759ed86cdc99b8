// Where curves pass over each other as they are seen from somewhere.
#pragma once

#include <Eigen/Core>
#include <span>
#include <tencer/geometry/measure.hpp>
#include <tencer/geometry/polyline.hpp>
#include <vector>

namespace tencer::fabricate {

struct Crossing {
  geometry::EdgePoint over{};  // `rod` is the curve's index
  geometry::EdgePoint under{};
  // Of the angle between the two as seen, from the one over to the one under: positive at a
  // right-handed crossing.
  double sine = 0.0;
  double height = 0.0;  // of one above the other, >= 0
};

// The eye is far away: rows of `view` are the directions to the right, up, and towards the eye.
// Edges of one curve that share a vertex do not cross. Where a crossing meets a vertex of the
// drawing it may be found on both edges, or on none. Sorted by the curve and place under.
std::vector<Crossing> crossings(std::span<const geometry::Polyline> curves,
                                const Eigen::Matrix3d& view);

}  // namespace tencer::fabricate
