// From where a structure shows most of itself.
#pragma once

#include <Eigen/Core>

namespace tencer::app {

// Rows: right, up, towards the reader: the principal axes of points (3 x n), the greatest extent to
// the right, the least towards the reader. Where extents are equal, x is right and z towards the
// reader.
Eigen::Matrix3d principal_axes(const Eigen::Matrix3Xd& points);

// What is seen along a direction that is not zero: z is up, or y where it is not across.
Eigen::Matrix3d axes_along(const Eigen::Vector3d& direction);

// The same structure from above it and from its right; axes: of the front.
Eigen::Matrix3d from_above(const Eigen::Matrix3d& axes);
Eigen::Matrix3d from_right(const Eigen::Matrix3d& axes);

// The principal axes, turned so that curves in planes along the axes are not seen edge-on.
Eigen::Matrix3d oblique_axes(const Eigen::Matrix3Xd& points);

}  // namespace tencer::app
