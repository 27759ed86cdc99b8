#include "detection/match.hpp"

#include <Eigen/Geometry>
#include <Eigen/QR>
#include <cmath>
#include <limits>
#include <vector>

namespace tencer::symmetry {
namespace {

struct PairFit {
  double squares = std::numeric_limits<double>::infinity();
  RodMap map{};
};

// The best of all shifts by whole samples, in both directions, of `moved` (a rod's samples after
// the map of space) along rod `image`.
PairFit fit_pair(const Sampled& sampled, const Eigen::Matrix3Xd& moved, int rod, int image) {
  const geometry::ArcLength& target = sampled.figure.rods[image];
  const double ratio = target.length() / sampled.figure.rods[rod].length();
  const Eigen::Matrix3Xd& points = sampled.rods[image].points;
  PairFit best;
  const auto consider = [&](const auto& candidate, double rate, double offset) {
    const double squares = (moved - candidate).squaredNorm();
    if (squares < best.squares) best = {squares, {image, rate, offset}};
  };
  if (!target.closed()) {
    consider(points, ratio, 0.0);
    consider(points.rowwise().reverse(), -ratio, target.length());
    return best;
  }
  // Column k of `ahead` is the sample k modulo the number of samples; of `back` the sample -k.
  Eigen::Matrix3Xd ahead(3, 2 * samples);
  ahead << points, points;
  Eigen::Matrix3Xd back(3, 2 * samples);
  for (int k = 0; k < 2 * samples; ++k) back.col(k) = ahead.col(2 * samples - 1 - k);
  for (int shift = 0; shift < samples; ++shift) {
    const double step = target.length() / samples;
    consider(ahead.middleCols(shift, samples), ratio, shift * step);
    // Sample k goes to sample 2 samples - 1 - (shift + k).
    consider(back.middleCols(shift, samples), -ratio, target.wrap(-(shift + 1) * step));
  }
  return best;
}

bool possible(const SampledRod& rod, const SampledRod& image, const Eigen::Matrix3d& matrix,
              const Eigen::Vector3d& translation, double slack, double diagonal) {
  const Eigen::Vector3d mean = matrix * rod.mean;
  const Eigen::Matrix3d moment = matrix * rod.moment * matrix.transpose() +
                                 mean * translation.transpose() + translation * mean.transpose() +
                                 translation * translation.transpose();
  return (mean + translation - image.mean).norm() <= slack &&
         (moment - image.moment).norm() <= 4.0 * slack * diagonal;
}

std::optional<std::vector<int>> match_anchors(const Eigen::Matrix3Xd& anchors,
                                              const Eigen::Matrix3d& matrix,
                                              const Eigen::Vector3d& translation) {
  std::vector<int> images;
  std::vector<bool> taken(anchors.cols(), false);
  for (Eigen::Index i = 0; i < anchors.cols(); ++i) {
    const Eigen::Vector3d moved = matrix * anchors.col(i) + translation;
    Eigen::Index nearest = 0;
    (anchors.colwise() - moved).colwise().squaredNorm().minCoeff(&nearest);
    if (taken[nearest]) return std::nullopt;
    taken[nearest] = true;
    images.push_back(static_cast<int>(nearest));
  }
  return images;
}

}  // namespace

Misfit misfit(const Sampled& sampled, const Operation& operation) {
  const Figure& figure = sampled.figure;
  Misfit worst;
  const auto consider = [&](double distance, int rod, int anchor) {
    if (const double relative = distance / sampled.diagonal; relative > worst.relative)
      worst = {relative, rod, anchor};
  };
  for (int r = 0; r < static_cast<int>(figure.rods.size()); ++r) {
    const RodMap& map = operation.rods[r];
    for (int i = 0; i < figure.curves[r].vertices(); ++i) {
      const Eigen::Vector3d moved =
          operation.matrix * figure.curves[r].points.col(i) + operation.translation;
      const double s = map.rate * figure.rods[r].knots()[i] + map.offset;
      consider((moved - place(sampled, map.rod, s).point).norm(), r, -1);
    }
  }
  for (Eigen::Index i = 0; i < figure.anchors.cols(); ++i) {
    const Eigen::Vector3d moved = operation.matrix * figure.anchors.col(i) + operation.translation;
    consider((moved - figure.anchors.col(operation.anchors[i])).norm(), -1, static_cast<int>(i));
  }
  return worst;
}

std::optional<Operation> match(const Sampled& sampled, const Eigen::Matrix3d& matrix,
                               const Eigen::Vector3d& translation, double max_misfit) {
  const int rods = static_cast<int>(sampled.rods.size());
  Operation result{.matrix = matrix, .translation = translation, .rods = {}, .anchors = {}};
  auto anchors = match_anchors(sampled.figure.anchors, matrix, translation);
  if (!anchors) return std::nullopt;
  result.anchors = std::move(*anchors);
  std::vector<bool> taken(rods, false);
  for (int r = 0; r < rods; ++r) {
    const Eigen::Matrix3Xd moved = (matrix * sampled.rods[r].points).colwise() + translation;
    PairFit best;
    for (int image = 0; image < rods; ++image) {
      if (taken[image] || !alike(sampled.figure, r, image)) continue;
      if (max_misfit > 0.0 && !possible(sampled.rods[r], sampled.rods[image], matrix, translation,
                                        max_misfit * sampled.diagonal, sampled.diagonal))
        continue;
      const PairFit fit = fit_pair(sampled, moved, r, image);
      if (fit.squares < best.squares) best = fit;
    }
    if (!std::isfinite(best.squares)) return std::nullopt;
    taken[best.map.rod] = true;
    result.rods.push_back(best.map);
  }
  return result;
}

void polish(const Sampled& sampled, Operation& operation, Polish what) {
  const Figure& figure = sampled.figure;
  const int rods = static_cast<int>(figure.rods.size());
  // Gauss-Newton. Unknowns: a turn and a translation of space, then one shift a rod; lengths over
  // the diagonal, shifts over the rod's length.
  const int map_unknowns = what == Polish::shifts_and_map ? 6 : 0;
  const int unknowns = map_unknowns + rods;
  for (int iteration = 0; iteration < 20; ++iteration) {
    Eigen::MatrixXd normal = Eigen::MatrixXd::Zero(unknowns, unknowns);
    Eigen::VectorXd gradient = Eigen::VectorXd::Zero(unknowns);
    for (int r = 0; r < rods; ++r) {
      const auto [image, rate, offset] = operation.rods[r];
      const bool shifts = figure.rods[image].closed();
      const int column = map_unknowns + r;
      for (int k = 0; k < samples; ++k) {
        const Eigen::Vector3d moved = operation.matrix * sampled.rods[r].points.col(k);
        const Place there = place(sampled, image, rate * sampled.rods[r].at[k] + offset);
        const Eigen::Vector3d miss = moved + operation.translation - there.point;
        Eigen::Matrix<double, 3, 7> rates = Eigen::Matrix<double, 3, 7>::Zero();
        rates.leftCols<3>() << 0, moved.z(), -moved.y(), -moved.z(), 0, moved.x(), moved.y(),
            -moved.x(), 0;
        rates.middleCols<3>(3) = sampled.diagonal * Eigen::Matrix3d::Identity();
        if (shifts) rates.col(6) = -figure.rods[image].length() * there.tangent;
        const Eigen::Matrix<double, 7, 7> square = rates.transpose() * rates;
        const Eigen::Matrix<double, 7, 1> slope = rates.transpose() * miss;
        normal.topLeftCorner(map_unknowns, map_unknowns) +=
            square.topLeftCorner(map_unknowns, map_unknowns);
        normal.block(0, column, map_unknowns, 1) += square.block(0, 6, map_unknowns, 1);
        normal.block(column, 0, 1, map_unknowns) += square.block(6, 0, 1, map_unknowns);
        normal(column, column) += square(6, 6);
        gradient.head(map_unknowns) += slope.head(map_unknowns);
        gradient[column] += slope[6];
      }
    }
    // A figure that turns into itself by any angle leaves a combination free: the least step.
    Eigen::CompleteOrthogonalDecomposition<Eigen::MatrixXd> solver;
    solver.setThreshold(1e-9);
    solver.compute(normal);
    const Eigen::VectorXd step = -solver.solve(gradient);
    if (!step.allFinite()) return;
    if (map_unknowns > 0) {
      const double angle = step.head<3>().norm();
      if (angle > 0.0) {
        const Eigen::AngleAxisd turn(angle, step.head<3>() / angle);
        operation.matrix = turn.toRotationMatrix() * operation.matrix;
      }
      operation.translation += sampled.diagonal * step.segment<3>(3);
    }
    for (int r = 0; r < rods; ++r) {
      RodMap& map = operation.rods[r];
      const geometry::ArcLength& target = figure.rods[map.rod];
      if (target.closed())
        map.offset = target.wrap(map.offset + target.length() * step[map_unknowns + r]);
    }
    if (step.cwiseAbs().maxCoeff() < 1e-14) return;
  }
}

}  // namespace tencer::symmetry
