#include <Eigen/Geometry>
#include <cmath>
#include <numbers>
#include <numeric>
#include <tencer/core/error.hpp>
#include <tencer/curves/analytic.hpp>
#include <tencer/geometry/sampling.hpp>

namespace tencer::curves {

using geometry::Curve;
using geometry::Polyline;

namespace {

using std::cos;
using std::sin;
using std::numbers::pi;

Curve torus_knot_curve(int p, int q, double major, double minor) {
  return [=](double t) {
    const double distance = major + minor * cos(q * t);
    return Eigen::Vector3d(distance * cos(p * t), distance * sin(p * t), minor * sin(q * t));
  };
}

Polyline closed_curve(const Curve& curve, int vertices) {
  return geometry::sample(curve, 0.0, 2.0 * pi, vertices, true);
}

}  // namespace

Polyline circle(double radius, int vertices) { return ellipse(radius, radius, vertices); }

Polyline ellipse(double semi_x, double semi_y, int vertices) {
  core::require(semi_x > 0 && semi_y > 0, "ellipse: needs positive semi-axes");
  return closed_curve(
      [=](double t) { return Eigen::Vector3d(semi_x * cos(t), semi_y * sin(t), 0.0); }, vertices);
}

Polyline helix(double diameter, double pitch, double turns, int vertices) {
  core::require(diameter > 0 && turns > 0, "helix: needs a positive diameter and turns");
  const double radius = diameter / 2.0;
  const double rise = pitch / (2.0 * pi);
  return geometry::sample(
      [=](double t) { return Eigen::Vector3d(radius * cos(t), radius * sin(t), rise * t); }, 0.0,
      2.0 * pi * turns, vertices, false);
}

Polyline torus_knot(int p, int q, double major, double minor, int vertices) {
  core::require(p > 0 && q > 0 && std::gcd(p, q) == 1, "torus_knot: needs coprime windings");
  core::require(minor > 0 && major > minor, "torus_knot: needs major > minor > 0");
  return closed_curve(torus_knot_curve(p, q, major, minor), vertices);
}

Polyline trefoil(TrefoilForm form, double curve_length, int vertices) {
  core::require(curve_length > 0, "trefoil: needs a positive length");
  Curve unit;
  switch (form) {
    case TrefoilForm::hypotrochoid:
      unit = [](double t) {
        return Eigen::Vector3d(sin(t) + 2.0 * sin(2.0 * t), cos(t) - 2.0 * cos(2.0 * t),
                               -sin(3.0 * t));
      };
      break;
    case TrefoilForm::torus_2_3:
      unit = torus_knot_curve(2, 3, 1.0, 0.4);
      break;
    case TrefoilForm::torus_3_2:
      unit = torus_knot_curve(3, 2, 1.0, 0.4);
      break;
  }
  const double scale = curve_length / geometry::length(unit, 0.0, 2.0 * pi);
  return closed_curve([&](double t) -> Eigen::Vector3d { return scale * unit(t); }, vertices);
}

std::vector<Polyline> twin_trefoils(double major, double minor, int vertices) {
  const Polyline first = torus_knot(2, 3, major, minor, vertices);
  Polyline second = first;
  second.points =
      Eigen::AngleAxisd(pi / 3.0, Eigen::Vector3d::UnitZ()).toRotationMatrix() * first.points;
  return {first, second};
}

std::vector<Polyline> borromean_ellipses(double long_axis, double short_axis, int vertices) {
  core::require(short_axis > 0 && long_axis > short_axis,
                "borromean_ellipses: needs long_axis > short_axis > 0");
  std::vector<Polyline> rings(3, ellipse(long_axis, short_axis, vertices));
  // Cyclic exchange of the axes: the long axes lie along x, y and z, the short along y, z and x.
  for (int ring = 1; ring < 3; ++ring)
    for (int axis = 0; axis < 3; ++axis)
      rings[ring].points.row((axis + ring) % 3) = rings[0].points.row(axis);
  return rings;
}

}  // namespace tencer::curves
