// A rigid map compared with a figure: which rod goes where, and how well it fits.
#pragma once

#include <Eigen/Core>
#include <optional>
#include <tencer/symmetry/operation.hpp>

#include "detection/sampled.hpp"

namespace tencer::symmetry {

// The worst distance of an operation, over the figure's diagonal, and the rod (or, if rod < 0, the
// anchor) where it occurs.
struct Misfit {
  double relative = 0.0;
  int rod = -1;
  int anchor = -1;
};

// How far the images of vertices are from the smooth curves they should lie on, and those of
// anchors from the anchors they should be.
Misfit misfit(const Sampled& sampled, const Operation& operation);

// The operation whose map of space is x -> matrix x + translation (in the centred figure): each rod
// goes to the like rod that it comes closest to, the shift along it fitted. None where two rods or
// anchors would go to the same one. `max_misfit` > 0: none also where a rod's mean and moments show
// that every image is further away than this.
std::optional<Operation> match(const Sampled& sampled, const Eigen::Matrix3d& matrix,
                               const Eigen::Vector3d& translation, double max_misfit);

// Least squares over all rods together: of the shifts along closed rods and, if asked, of the map
// of space too. Keeps which rod goes where.
enum class Polish { shifts, shifts_and_map };
void polish(const Sampled& sampled, Operation& operation, Polish what);

}  // namespace tencer::symmetry
