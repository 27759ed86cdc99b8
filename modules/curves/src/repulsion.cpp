#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>
#include <tencer/core/error.hpp>
#include <tencer/curves/repulsion.hpp>
#include <tencer/geometry/measure.hpp>
#include <tencer/geometry/sampling.hpp>
#include <utility>
#include <vector>

#include "quasi_newton.hpp"
#include "tangent_point.hpp"

namespace tencer::curves {

using geometry::Polyline;

namespace {

using Eigen::Matrix3Xd;
using Eigen::Vector3d;

// Half the least distance of two edges that share no vertex. While vertices move in straight lines
// by less than this, such edges stay apart, and the knot stays the same.
double room(const Polyline& curve) {
  const int n = curve.vertices();
  const Matrix3Xd edges = geometry::edge_vectors(curve);
  const Eigen::VectorXd half = edges.colwise().norm().transpose() / 2;
  const Matrix3Xd midpoints = curve.points + edges / 2;
  double min_distance = std::numeric_limits<double>::infinity();
  for (int i = 0; i < n; ++i)
    for (int j = i + 2; j < n - (i == 0 ? 1 : 0); ++j) {
      const double at_least = (midpoints.col(i) - midpoints.col(j)).norm() - half[i] - half[j];
      if (at_least >= min_distance) continue;
      const Vector3d a = curve.points.col(i);
      const Vector3d b = curve.points.col(j);
      min_distance =
          std::min(min_distance,
                   geometry::segment_approach(a, a + edges.col(i), b, b + edges.col(j)).distance);
    }
  return min_distance / 2;
}

double max_move(const Matrix3Xd& moves) { return moves.colwise().norm().maxCoeff(); }

Polyline of_unit_length(Polyline curve) {
  curve.points.colwise() -= Vector3d(curve.points.rowwise().mean());
  curve.points /= geometry::edge_lengths(curve).sum();
  return curve;
}

// The inverse of |k|^(2 s), s = 5/3, in the Fourier basis of n evenly spaced vertices: a circulant
// matrix. The mean, which the energy does not depend on, stays out.
Eigen::MatrixXd inverse_sobolev_metric(int n) {
  using std::numbers::pi;
  constexpr double s = 5.0 / 3.0;
  Eigen::VectorXd row = Eigen::VectorXd::Zero(n);
  for (int k = 1; k < n; ++k) {
    const double frequency = n / pi * std::sin(pi * k / n);
    for (int i = 0; i < n; ++i)
      row[i] += std::pow(frequency, -2 * s) / n * std::cos(2 * pi * (k * i % n) / n);
  }
  Eigen::MatrixXd matrix(n, n);
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < n; ++j) matrix(i, j) = row[std::abs(i - j)];
  return matrix;
}

struct Stage {
  Polyline curve;
  TangentPoint value;
};

// The step along the direction, evenly spaced again, when strands have room for it.
std::optional<Stage> moved(const Polyline& curve, const Matrix3Xd& step) {
  Polyline next = curve;
  next.points += step;
  Polyline even = geometry::resample(next, curve.vertices());
  if (max_move(even.points - next.points) >= room(next)) return std::nullopt;
  even = of_unit_length(std::move(even));
  TangentPoint value = tangent_point_energy(even);
  return Stage{std::move(even), std::move(value)};
}

}  // namespace

void RepelOptions::validate() const {
  core::require(max_iterations >= 0, "RepelOptions: max_iterations must not be negative");
  core::require(min_decrease >= 0, "RepelOptions: min_decrease must not be negative");
  core::require(patience > 0, "RepelOptions: patience must be positive");
}

Repelled repel(const Polyline& curve, const RepelOptions& options) {
  options.validate();
  const int n = curve.vertices();
  core::require(curve.closed && n >= 8, "repel: needs a closed curve of 8 vertices");
  Stage stage{of_unit_length(geometry::resample(curve, n)), {}};
  constexpr double touching = 1e-9;  // of the length
  core::require(room(stage.curve) > touching, "repel: the curve crosses itself");
  stage.value = tangent_point_energy(stage.curve);

  constexpr double min_step = 1e-10;
  QuasiNewton model(inverse_sobolev_metric(n));
  Repelled result;
  std::vector<double> energies{stage.value.energy};
  const auto stalls = [&] {
    const int steps = result.iterations;
    return steps >= options.patience && energies[steps - options.patience] - energies[steps] <
                                            options.min_decrease * energies[steps];
  };
  while (result.iterations < options.max_iterations && !result.converged) {
    Matrix3Xd step = model.direction(stage.value.gradient);
    const double slope = stage.value.gradient.cwiseProduct(step).sum();
    const double allowed = 0.9 * room(stage.curve);
    const double wanted = max_move(step);
    double factor = model.scaled() ? std::min(1.0, allowed / wanted) : allowed / wanted;
    std::optional<Stage> next;
    if (slope < 0)
      for (; factor * wanted > min_step; factor /= 2) {
        next = moved(stage.curve, factor * step);
        if (next && next->value.energy < stage.value.energy + 0.1 * factor * slope) break;
        next.reset();
      }
    if (next) {
      model.learn(next->curve.points - stage.curve.points,
                  next->value.gradient - stage.value.gradient);
      stage = *std::move(next);
      energies.push_back(stage.value.energy);
      ++result.iterations;
      result.converged = stalls();
    } else if (model.scaled()) {
      model.forget();
    } else {
      result.converged = true;
    }
  }
  result.curve = std::move(stage.curve);
  result.energy = stage.value.energy;
  return result;
}

}  // namespace tencer::curves
