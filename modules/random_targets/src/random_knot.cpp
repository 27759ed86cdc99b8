#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <random>
#include <tencer/core/error.hpp>
#include <tencer/equilibrium/solve.hpp>
#include <tencer/geometry/measure.hpp>
#include <tencer/geometry/sampling.hpp>
#include <tencer/random_targets/random_knot.hpp>

namespace tencer::random_targets {
namespace {

using Eigen::Vector3d;
using geometry::Polyline;

// The standard's engine gives the same bits everywhere; its distributions do not.
class Draw {
 public:
  explicit Draw(std::uint64_t seed) : engine_(seed) {}

  // In [0, 1), all multiples of 2^-53.
  double unit() { return static_cast<double>(engine_() >> 11) * 0x1p-53; }
  double between(double low, double high) { return low + (high - low) * unit(); }

 private:
  std::mt19937_64 engine_;
};

// A closed curve of a few random harmonics, of length 1.
Polyline random_loop(Draw& draw, int vertices) {
  constexpr int harmonics = 3;
  Eigen::Matrix<double, 3, 2 * harmonics> amplitudes;
  for (int k = 0; k < harmonics; ++k)
    for (int column : {2 * k, 2 * k + 1})
      for (int axis = 0; axis < 3; ++axis) amplitudes(axis, column) = draw.between(-1, 1) / (k + 1);
  const geometry::Curve curve = [&](double t) {
    Vector3d point = Vector3d::Zero();
    for (int k = 0; k < harmonics; ++k)
      point += std::cos((k + 1) * t) * amplitudes.col(2 * k) +
               std::sin((k + 1) * t) * amplitudes.col(2 * k + 1);
    return point;
  };
  constexpr double period = 2 * std::numbers::pi;
  Polyline loop = geometry::sample(curve, 0, period, vertices, true);
  loop.points /= geometry::length(curve, 0, period);
  return loop;
}

// Springs between points at least a tenth of the rod apart, for a rod of length and bending
// stiffness 1. A few are each about as stiff as a ring of the rod is across (1664 EI / L^3); many
// share what a dozen would pull, or they would draw the rod together until it crosses itself.
std::vector<springs::Cable> random_springs(Draw& draw, int count) {
  std::vector<springs::Cable> cables;
  for (int i = 0; i < count; ++i) {
    const double from = draw.unit();
    const double to = from + draw.between(0.1, 0.9);
    const double stiffness =
        1664 * std::min(1.0, 12.0 / count) * std::pow(10.0, draw.between(-0.5, 0.5));
    cables.push_back({.a = springs::OnRod{0, from},
                      .b = springs::OnRod{0, to < 1 ? to : to - 1},
                      .stiffness = stiffness});
  }
  return cables;
}

// A slender rod of length 1 and bending stiffness 1, with the slenderness of the paper's models.
der::Rod unit_rod(int vertices) {
  constexpr double radius = 0.0015;
  der::Rod rod;
  rod.closed = true;
  rod.section = der::solid_circle(4 / (std::numbers::pi * std::pow(radius, 4)), 0.3, radius);
  rod.rest_lengths = Eigen::VectorXd::Constant(vertices, 1.0 / vertices);
  return rod;
}

// The least distance between edges that are more than half a circle of this diameter apart along
// the closed curve of length 1.
double self_distance(const Polyline& curve, double diameter) {
  const int n = curve.vertices();
  const int apart = static_cast<int>(std::ceil(std::numbers::pi / 2 * diameter * n)) + 1;
  const auto point = [&](int i) -> Vector3d { return curve.points.col(i % n); };
  double least = std::numeric_limits<double>::infinity();
  for (int i = 0; i < n; ++i)
    for (int j = i + apart; j <= i + n - apart && j < n; ++j)
      least = std::min(
          least,
          geometry::segment_approach(point(i), point(i + 1), point(j), point(j + 1)).distance);
  return least;
}

// The greatest curvature, 2 tan(turning angle / 2) over the distance of vertices.
double greatest_curvature(const Polyline& curve) {
  const Eigen::Matrix3Xd edges = geometry::edge_vectors(curve);
  const int n = curve.vertices();
  double greatest = 0;
  for (int i = 0; i < n; ++i) {
    const Vector3d a = edges.col(i);
    const Vector3d b = edges.col((i + 1) % n);
    const double binormal = 2 * a.cross(b).norm() / (a.norm() * b.norm() + a.dot(b));
    greatest = std::max(greatest, binormal * 2 / (a.norm() + b.norm()));
  }
  return greatest;
}

// The least of the curve's three principal extents, root mean square.
double thickness(const Polyline& curve) {
  const Eigen::Matrix3Xd centred = curve.points.colwise() - curve.points.rowwise().mean();
  const Eigen::Matrix3d covariance = centred * centred.transpose() / curve.vertices();
  const double least =
      Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(covariance).eigenvalues().minCoeff();
  return std::sqrt(std::max(least, 0.0));
}

bool acceptable(const Polyline& curve, double clearance) {
  return thickness(curve) > clearance && greatest_curvature(curve) < 1 / clearance &&
         self_distance(curve, 2 * clearance) > clearance;
}

}  // namespace

std::optional<const char*> random_knot_problem(const RandomKnotOptions& options) {
  if (options.cables < 1 || options.cables > 200) return "cables must be from 1 to 200";
  if (!std::isfinite(options.length) || options.length <= 0)
    return "length must be a positive number";
  if (options.vertices < 30 || options.vertices > 100000)
    return "vertices must be from 30 to 100000";
  return std::nullopt;
}

std::optional<RandomKnot> random_knot(const RandomKnotOptions& options) {
  core::require(!random_knot_problem(options), "random_knot: unusable options");
  core::require(options.clearance > 0 && options.clearance < 0.1,
                "random_knot: clearance must be between 0 and 0.1");
  Draw draw(options.seed);
  for (int i = 0; i < options.draws; ++i) {
    const Polyline loop = random_loop(draw, options.vertices);
    model::Structure structure{.rods = {unit_rod(options.vertices)},
                               .cables = random_springs(draw, options.cables)};
    const equilibrium::System system(structure);
    const auto settled = equilibrium::solve(system, model::make_state(structure, {loop.points}));
    if (!settled.usable()) continue;
    RandomKnot knot{.curve = {settled.state[0].x, true}, .cables = std::move(structure.cables)};
    if (!acceptable(knot.curve, options.clearance)) continue;
    knot.curve.points *= options.length;
    for (springs::Cable& cable : knot.cables) {
      std::get<springs::OnRod>(cable.a).s *= options.length;
      std::get<springs::OnRod>(cable.b).s *= options.length;
      cable.stiffness /= std::pow(options.length, 3);
    }
    return knot;
  }
  return std::nullopt;
}

}  // namespace tencer::random_targets
