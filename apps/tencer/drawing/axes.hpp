// From where a structure shows most of itself.
#pragma once

#include <Eigen/Core>
#include <tencer/model/view.hpp>
#include <vector>

namespace tencer::app {

// Rows: right, up, towards the reader: the principal axes of points (3 x n), the greatest extent to
// the right, the least towards the reader. Where extents are equal, x is right and z towards the
// reader.
Eigen::Matrix3d principal_axes(const Eigen::Matrix3Xd& points);

// What is seen along the view that weighs most, of one or more: z is up, or y where that is not
// across.
Eigen::Matrix3d axes_along(const std::vector<model::View>& views);

// The same structure from above it and from its right; axes: of the front.
Eigen::Matrix3d from_above(const Eigen::Matrix3d& axes);
Eigen::Matrix3d from_right(const Eigen::Matrix3d& axes);

// The same turned so that curves in planes along the axes are not seen edge-on.
Eigen::Matrix3d oblique(const Eigen::Matrix3d& axes);
// Of the principal axes.
Eigen::Matrix3d oblique_axes(const Eigen::Matrix3Xd& points);

}  // namespace tencer::app
