#include <set>
#include <tencer/core/error.hpp>
#include <tencer/geometry/sampling.hpp>
#include <tencer/model/rest_shape.hpp>
#include <tencer/model/subdivision.hpp>
#include <tuple>

namespace tencer::model {
namespace {

// Which coordinates of which vertices are pinned: (rod, vertex, axis).
using Held = std::set<std::tuple<int, int, int>>;

Held held_coordinates(const Structure& structure) {
  Held held;
  for (const Pin& pin : structure.pins)
    for (int axis = 0; axis < 3; ++axis)
      if (pin.axes[axis]) held.insert({pin.rod, pin.vertex, axis});
  return held;
}

// The vertex after an edge.
int end_of(const der::Rod& rod, int edge) { return (edge + 1) % rod.vertices(); }

bool is_held(const Held& held, const der::Rod& rod, int number, int edge, int axis) {
  return held.contains({number, edge, axis}) && held.contains({number, end_of(rod, edge), axis});
}

// Hermite's cubics between the vertices; straight where an edge is held.
Eigen::Matrix3Xd subdivided(const Eigen::Matrix3Xd& x, const der::Rod& rod, int number,
                            const Held& held, int times) {
  const Eigen::Matrix3Xd slope = geometry::slopes(x, {rod.rest_lengths, rod.closed});
  Eigen::Matrix3Xd fine(3, rod.edges() * times + (rod.closed ? 0 : 1));
  for (int j = 0; j < rod.edges(); ++j) {
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

der::Rod subdivided(const der::Rod& rod, int times) {
  der::Rod fine = rod;
  fine.rest_lengths =
      repeated(Eigen::MatrixXd(rod.rest_lengths.transpose()), times).transpose() / times;
  copy_rest_shape(rod, fine);
  return fine;
}

}  // namespace

Design subdivided(const Design& design, int times) {
  core::require(times >= 1, "subdivided: edges are divided into at least 1");
  const Held held = held_coordinates(design.structure);
  Design fine = design;
  auto& pins = fine.structure.pins;
  for (Pin& pin : pins) pin.vertex *= times;
  for (int r = 0; r < static_cast<int>(design.structure.rods.size()); ++r) {
    const der::Rod& rod = design.structure.rods[r];
    fine.structure.rods[r] = subdivided(rod, times);
    fine.target[r] = subdivided(design.target[r], rod, r, held, times);
    fine.pose[r] = subdivided(design.pose[r], rod, r, held, times);
    fine.target_directors[r] = repeated(design.target_directors[r], times);
    fine.pose_directors[r] = repeated(design.pose_directors[r], times);
    for (int j = 0; j < rod.edges(); ++j) {
      Pin pin{.rod = r};
      for (int axis = 0; axis < 3; ++axis) pin.axes[axis] = is_held(held, rod, r, j, axis);
      if (pin.axes == std::array{false, false, false}) continue;
      for (int k = 1; k < times; ++k) {
        pin.vertex = j * times + k;
        pins.push_back(pin);
      }
    }
  }
  return fine;
}

}  // namespace tencer::model
