// Shapes of rods at rest, taken from curves and from other rods.
#pragma once

#include <optional>
#include <tencer/der/rod.hpp>
#include <tencer/geometry/polyline.hpp>

namespace tencer::model {

// How a rod is bent at rest: straight; or with the same curvature (1 / length) all along, towards
// the section's first axis; or along a curve, open or closed and as long as the rod, with the
// section's first axis at its start turned to `director`, as far as that is perpendicular to it.
struct RestShape {
  double curvature = 0.0;
  std::optional<geometry::Polyline> curve = std::nullopt;
  std::optional<Eigen::Vector3d> director = std::nullopt;
};

// Bends `rod` at rest so; its rest lengths stay.
void set_rest_shape(const RestShape& shape, der::Rod& rod);

// Bends and twists `rod` at rest as `from` is at the same fractions of the length: the curvature
// per length, linear between the vertices of `from`, so that equal fractions give equal bends.
void copy_rest_shape(const der::Rod& from, der::Rod& rod);

}  // namespace tencer::model
