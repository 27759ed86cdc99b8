// A figure moved to its centroid, with what the search for symmetries looks up again and again.
#pragma once

#include <Eigen/Core>
#include <tencer/symmetry/figure.hpp>
#include <tencer/symmetry/operation.hpp>
#include <vector>

namespace tencer::symmetry {

// Points on each rod at equal distances of arc length at rest; fine enough to tell the shifts of a
// rod apart, which are then refined on the curve itself.
inline constexpr int samples = 256;

// tangents: 3 x n, the derivative in arc length at rest at each vertex. points: 3 x samples, at the
// arc lengths `at`. mean, moment: the averages of x and x x^T over these.
struct SampledRod {
  Eigen::Matrix3Xd tangents{};
  Eigen::Matrix3Xd points{};
  Eigen::VectorXd at{};
  Eigen::Vector3d mean = Eigen::Vector3d::Zero();
  Eigen::Matrix3d moment = Eigen::Matrix3d::Zero();
};

// figure: the original moved by -centre, the centroid by length at rest. diagonal: of its bounding
// box.
struct Sampled {
  Figure figure{};
  Eigen::Vector3d centre = Eigen::Vector3d::Zero();
  double diagonal = 0.0;
  std::vector<SampledRod> rods{};
};

Sampled sample(const Figure& figure);

// May the one rod go to the other: of one class, both open or both closed, lengths within 1 %?
bool alike(const Figure& figure, int rod, int other);

// The point of a rod at arc length s at rest, and its derivative in s, on the smooth curve through
// the vertices (cubic in each edge): the polyline itself is off by the sagitta of its edges, which
// at a hundred vertices can exceed the tolerance, so that no rotation would fit that does not take
// vertices to vertices.
struct Place {
  Eigen::Vector3d point;
  Eigen::Vector3d tangent;
};
Place place(const Sampled& sampled, int rod, double s);

}  // namespace tencer::symmetry
