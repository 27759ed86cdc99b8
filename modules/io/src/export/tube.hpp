// Surfaces around lines.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <tencer/geometry/polyline.hpp>
#include <vector>

namespace tencer::io {

// Triangles, three corners each, anticlockwise as seen from outside.
struct Mesh {
  std::vector<Eigen::Vector3d> points{};
  std::vector<Eigen::Vector3d> normals{};
  std::vector<std::uint32_t> corners{};
};

// A section's outline in its own axes, and where it faces (2 x n each). From each point to the next
// runs an edge of the outline; the last is joined to the first.
struct Outline {
  Eigen::Matrix2Xd points{};
  Eigen::Matrix2Xd normals{};
};
Outline round_outline(double radius);
// Each corner twice, for its two sides. width: along the first axis.
Outline rectangle_outline(double width, double height);

// The outline carried along a line, its first axis where `axes` point (3 x vertices; either way, as
// far as they are perpendicular to the line), or turning as little as can be where there are none.
// Open lines get flat ends.
Mesh tube(const geometry::Polyline& line, const Outline& outline, const Eigen::Matrix3Xd& axes);

Mesh cube(const Eigen::Vector3d& centre, double side);

}  // namespace tencer::io
