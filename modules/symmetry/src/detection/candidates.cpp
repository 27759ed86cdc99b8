#include "detection/candidates.hpp"

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <optional>
#include <tencer/registration/rigid.hpp>

namespace tencer::symmetry {
namespace {

using Fits = std::array<registration::OrthogonalFit, 2>;

// The samples of a rod after the map s -> direction * s + shift along rod `image`.
Eigen::Matrix3Xd images(const Sampled& sampled, int rod, int image, int direction, double shift) {
  const double rate =
      direction * sampled.figure.rods[image].length() / sampled.figure.rods[rod].length();
  Eigen::Matrix3Xd result(3, samples);
  for (int k = 0; k < samples; ++k)
    result.col(k) = place(sampled, image, rate * sampled.rods[rod].at[k] + shift).point;
  return result;
}

// The shift in [from, to] where the fit with a matrix of the given kind (0 proper, 1 improper) is
// best, by golden section.
Eigen::Matrix3d best_between(const Sampled& sampled, int rod, int image, int direction, int kind,
                             double from, double to) {
  constexpr double golden = 0.6180339887498949;
  const Eigen::Matrix3Xd& points = sampled.rods[rod].points;
  const auto turns = [&](double shift) {
    return registration::orthogonal_fits(points, images(sampled, rod, image, direction, shift));
  };
  double low = to - golden * (to - from), high = from + golden * (to - from);
  Fits at_low = turns(low), at_high = turns(high);
  for (int i = 0; i < 25; ++i) {
    if (at_low[kind].squares < at_high[kind].squares) {
      to = high;
      high = low;
      at_high = at_low;
      low = to - golden * (to - from);
      at_low = turns(low);
    } else {
      from = low;
      low = high;
      at_low = at_high;
      high = from + golden * (to - from);
      at_high = turns(high);
    }
  }
  return at_low[kind].matrix;
}

// Matrices under which one rod comes close to the like rods and to itself.
std::vector<Eigen::Matrix3d> from_rod(const Sampled& sampled, int rod, double tolerance) {
  std::vector<Eigen::Matrix3d> result;
  const Figure& figure = sampled.figure;
  const Eigen::Matrix3Xd& points = sampled.rods[rod].points;
  for (int image = 0; image < static_cast<int>(sampled.rods.size()); ++image) {
    if (!alike(figure, rod, image)) continue;
    const double length = figure.rods[image].length();
    for (const int direction : {1, -1}) {
      if (!figure.rods[image].closed()) {
        const Fits turns = registration::orthogonal_fits(
            points, images(sampled, rod, image, direction, direction > 0 ? 0.0 : length));
        for (int kind = 0; kind < 2; ++kind) result.push_back(turns[kind].matrix);
        continue;
      }
      const double step = length / samples;
      // Samples are at most half a step from where the best shift would put them.
      const double near = tolerance * sampled.diagonal + step / 2.0;
      std::vector<Fits> turns;
      for (int shift = 0; shift < samples; ++shift)
        turns.push_back(registration::orthogonal_fits(
            points, images(sampled, rod, image, direction, shift * step)));
      for (int kind = 0; kind < 2; ++kind) {
        for (int shift = 0; shift < samples; ++shift) {
          const double here = turns[shift][kind].squares;
          if (here > samples * near * near) continue;
          if (here > turns[(shift + samples - 1) % samples][kind].squares) continue;
          if (here > turns[(shift + 1) % samples][kind].squares) continue;
          result.push_back(best_between(sampled, rod, image, direction, kind, (shift - 1) * step,
                                        (shift + 1) * step));
        }
      }
    }
  }
  return result;
}

// The axis about which any turn maps a rod onto itself: a straight rod through the centroid or a
// circle around a line through it.
struct Axis {
  Eigen::Vector3d direction;
  bool line;
};

std::optional<Axis> round_axis(const Sampled& sampled, int rod, double tolerance) {
  const double allowed = tolerance * sampled.diagonal;
  const SampledRod& curve = sampled.rods[rod];
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> about_centre(curve.moment);
  if (about_centre.eigenvalues()[1] <= allowed * allowed)
    return Axis{about_centre.eigenvectors().col(2), true};
  if (!sampled.figure.rods[rod].closed()) return std::nullopt;
  constexpr int shifts = 16;
  for (int i = 1; i < shifts; ++i) {
    // Not whole parts of the length, where a polygon fits itself.
    const double shift = sampled.figure.rods[rod].length() * (i + 0.37) / shifts;
    const Eigen::Matrix3Xd to = images(sampled, rod, rod, 1, shift);
    const Fits turns = registration::orthogonal_fits(curve.points, to);
    const double worst = (turns[0].matrix * curve.points - to).colwise().norm().maxCoeff();
    if (worst > allowed) return std::nullopt;
  }
  const Eigen::Matrix3d about_mean = curve.moment - curve.mean * curve.mean.transpose();
  return Axis{Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(about_mean).eigenvectors().col(0),
              false};
}

// An orthonormal frame with its first column along `first` and its second towards `second`.
Eigen::Matrix3d frame(const Eigen::Vector3d& first, const Eigen::Vector3d& second) {
  Eigen::Matrix3d result;
  result.col(0) = first.normalized();
  result.col(1) = (second - second.dot(result.col(0)) * result.col(0)).normalized();
  result.col(2) = result.col(0).cross(result.col(1));
  return result;
}

// Both maps of one frame onto another: proper and improper.
void add_maps(std::vector<Eigen::Matrix3d>& maps, const Eigen::Matrix3d& from,
              const Eigen::Matrix3d& to) {
  for (const double sign : {1.0, -1.0})
    maps.push_back(to * Eigen::Vector3d(1.0, 1.0, sign).asDiagonal() * from.transpose());
}

// The maps that take the axes of two rods that differ to those of rods like them.
std::vector<Eigen::Matrix3d> from_two_axes(const Sampled& sampled, const std::vector<Axis>& axes,
                                           int other, double slack) {
  std::vector<Eigen::Matrix3d> maps;
  const Eigen::Vector3d first = axes[0].direction;
  const Eigen::Vector3d second = axes[other].direction;
  const Eigen::Matrix3d from = frame(first, second);
  const auto add = [&](const Eigen::Vector3d& to_first, const Eigen::Vector3d& to_second) {
    if (std::abs(to_first.dot(to_second) - first.dot(second)) <= slack)
      add_maps(maps, from, frame(to_first, to_second));
  };
  const int rods = static_cast<int>(axes.size());
  for (int i = 0; i < rods; ++i)
    for (int j = 0; j < rods; ++j) {
      if (!alike(sampled.figure, 0, i) || !alike(sampled.figure, other, j)) continue;
      for (const double sign_i : {1.0, -1.0})
        for (const double sign_j : {1.0, -1.0})
          add(sign_i * axes[i].direction, sign_j * axes[j].direction);
    }
  return maps;
}

// The maps that keep an axis and take the anchor furthest off it to one as far off; none when all
// anchors are on the axis.
std::vector<Eigen::Matrix3d> from_anchors(const Sampled& sampled, const Eigen::Vector3d& axis,
                                          double tolerance) {
  std::vector<Eigen::Matrix3d> maps;
  const Eigen::Matrix3Xd& anchors = sampled.figure.anchors;
  const auto off_axis = [&](Eigen::Index i) { return axis.cross(anchors.col(i)).norm(); };
  Eigen::Index furthest = -1;
  for (Eigen::Index i = 0; i < anchors.cols(); ++i)
    if (off_axis(i) > tolerance * sampled.diagonal &&
        (furthest < 0 || off_axis(i) > off_axis(furthest)))
      furthest = i;
  if (furthest < 0) return maps;
  const Eigen::Matrix3d from = frame(axis, anchors.col(furthest));
  for (Eigen::Index i = 0; i < anchors.cols(); ++i) {
    if (std::abs(off_axis(i) - off_axis(furthest)) > 2.0 * tolerance * sampled.diagonal) continue;
    for (const double sign : {1.0, -1.0}) add_maps(maps, from, frame(sign * axis, anchors.col(i)));
  }
  return maps;
}

// When every rod is round about an axis: two axes that differ decide; else an anchor off the axis;
// else any angle is as good as another.
Candidates from_axes(const Sampled& sampled, const std::vector<Axis>& axes, double tolerance,
                     int continuous_fold) {
  const Eigen::Vector3d first = axes[0].direction;
  const auto off_first = [&](int r) { return first.cross(axes[r].direction).norm(); };
  int other = 0;
  for (int r = 1; r < static_cast<int>(axes.size()); ++r)
    if (off_first(r) > off_first(other)) other = r;
  // Circles and lines within the tolerance have directions within a few times the tolerance.
  const double slack = 20.0 * tolerance;
  if (off_first(other) > slack) return {.matrices = from_two_axes(sampled, axes, other, slack)};
  Candidates result{.matrices = from_anchors(sampled, first, tolerance)};
  if (!result.matrices.empty()) return result;
  result.continuous = true;
  // Turns of straight rods about themselves do nothing at all.
  const bool lines = std::ranges::all_of(axes, [](const Axis& axis) { return axis.line; });
  const int fold = lines ? 1 : continuous_fold;
  const Eigen::Matrix3d from = frame(first, first.unitOrthogonal());
  for (int i = 0; i < fold; ++i) {
    const double angle = 2.0 * std::numbers::pi * i / fold;
    const Eigen::Vector3d second = std::cos(angle) * from.col(1) + std::sin(angle) * from.col(2);
    for (const double sign : {1.0, -1.0})
      add_maps(result.matrices, from, frame(sign * first, second));
  }
  return result;
}

}  // namespace

Candidates candidates(const Sampled& sampled, double tolerance, int continuous_fold) {
  const int rods = static_cast<int>(sampled.rods.size());
  std::vector<Axis> axes;
  // The rod to search with: not round, well away from straight, with few like it.
  int reference = -1;
  double least = 0.0;
  for (int r = 0; r < rods; ++r) {
    if (const auto axis = round_axis(sampled, r, tolerance)) {
      axes.push_back(*axis);
      continue;
    }
    int choices = 0;
    for (int image = 0; image < rods; ++image) choices += alike(sampled.figure, r, image) ? 1 : 0;
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> moment(sampled.rods[r].moment,
                                                                Eigen::EigenvaluesOnly);
    const bool slim = std::sqrt(moment.eigenvalues()[1]) < 0.02 * sampled.diagonal;
    const double cost = choices + (slim ? rods : 0);
    if (reference < 0 || cost < least) {
      reference = r;
      least = cost;
    }
  }
  if (reference < 0) return from_axes(sampled, axes, tolerance, continuous_fold);
  return {.matrices = from_rod(sampled, reference, tolerance), .continuous = false};
}

}  // namespace tencer::symmetry
