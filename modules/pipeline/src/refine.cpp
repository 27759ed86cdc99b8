#include <set>
#include <tencer/core/error.hpp>
#include <tencer/geometry/sampling.hpp>
#include <tencer/pipeline/refine.hpp>
#include <tuple>

#include "rest_shape.hpp"

namespace tencer::pipeline {
namespace {

// Which coordinates of which vertices are pinned: (rod, vertex, axis).
using Held = std::set<std::tuple<int, int, int>>;

Held held_coordinates(const io::Design& design) {
  Held held;
  for (const io::Pin& pin : design.pinned)
    for (int axis = 0; axis < 3; ++axis)
      if (pin.axes[axis]) held.insert({pin.rod, pin.vertex, axis});
  return held;
}

// The vertex after an edge.
int end_of(const io::DesignRod& rod, int edge) {
  return (edge + 1) % static_cast<int>(rod.target.cols());
}

bool is_held(const Held& held, const io::DesignRod& rod, int number, int edge, int axis) {
  return held.contains({number, edge, axis}) && held.contains({number, end_of(rod, edge), axis});
}

// Hermite's cubics between the vertices; straight where an edge is held.
Eigen::Matrix3Xd refined_points(const Eigen::Matrix3Xd& x, const io::DesignRod& rod, int number,
                                const Held& held, int times) {
  const int edges = static_cast<int>(rod.rest_lengths.size());
  const Eigen::Matrix3Xd slope = geometry::slopes(x, {rod.rest_lengths, rod.closed});
  Eigen::Matrix3Xd fine(3, edges * times + (rod.closed ? 0 : 1));
  for (int j = 0; j < edges; ++j) {
    const int next = end_of(rod, j);
    const Eigen::Vector3d d = x.col(next) - x.col(j);
    const Eigen::Vector3d from = rod.rest_lengths[j] * slope.col(j) - d;
    const Eigen::Vector3d to = rod.rest_lengths[j] * slope.col(next) - d;
    for (int k = 0; k < times; ++k) {
      const double t = static_cast<double>(k) / times;
      Eigen::Vector3d bulge = t * (1 - t) * ((1 - t) * from - t * to);
      for (int axis = 0; axis < 3; ++axis)
        if (is_held(held, rod, number, j, axis)) bulge[axis] = 0;
      fine.col(j * times + k) = x.col(j) + t * d + bulge;
    }
  }
  if (!rod.closed) fine.col(fine.cols() - 1) = x.col(x.cols() - 1);
  return fine;
}

// Each column `times` times.
template <class Matrix>
Matrix repeated(const Matrix& columns, int times) {
  Matrix result(columns.rows(), columns.cols() * times);
  for (Eigen::Index j = 0; j < result.cols(); ++j) result.col(j) = columns.col(j / times);
  return result;
}

io::DesignRod refined_rod(const io::DesignRod& rod, int number, const Held& held, int times) {
  io::DesignRod fine = rod;
  fine.rest_lengths =
      repeated(Eigen::MatrixXd(rod.rest_lengths.transpose()), times).transpose() / times;
  fine.target = refined_points(rod.target, rod, number, held, times);
  fine.pose = refined_points(rod.pose, rod, number, held, times);
  fine.target_directors = repeated(rod.target_directors, times);
  fine.pose_directors = repeated(rod.pose_directors, times);
  const der::Rod at_rest{.closed = rod.closed,
                         .section = {},
                         .rest_lengths = rod.rest_lengths,
                         .rest_curvature = rod.rest_curvature,
                         .rest_twist = rod.rest_twist};
  der::Rod fine_at_rest{.closed = rod.closed, .section = {}, .rest_lengths = fine.rest_lengths};
  copy_rest_shape(at_rest, fine_at_rest);
  fine.rest_curvature = fine_at_rest.rest_curvature;
  fine.rest_twist = fine_at_rest.rest_twist;
  return fine;
}

}  // namespace

io::Design refined(const io::Design& design, int times) {
  core::require(times >= 1, "refined: edges are divided into at least 1");
  const Held held = held_coordinates(design);
  io::Design fine = design;
  fine.pinned.clear();
  for (io::Pin pin : design.pinned) {
    pin.vertex *= times;
    fine.pinned.push_back(pin);
  }
  for (int r = 0; r < static_cast<int>(design.rods.size()); ++r) {
    const io::DesignRod& rod = design.rods[r];
    fine.rods[r] = refined_rod(rod, r, held, times);
    for (int j = 0; j < rod.rest_lengths.size(); ++j) {
      io::Pin pin{.rod = r};
      for (int axis = 0; axis < 3; ++axis) pin.axes[axis] = is_held(held, rod, r, j, axis);
      if (pin.axes == std::array{false, false, false}) continue;
      for (int k = 1; k < times; ++k) {
        pin.vertex = j * times + k;
        fine.pinned.push_back(pin);
      }
    }
  }
  return fine;
}

}  // namespace tencer::pipeline
