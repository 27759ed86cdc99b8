#include "elastica.hpp"

#include <cmath>
#include <limits>
#include <tencer/core/error.hpp>
#include <vector>

namespace tencer::app::stress {
namespace {

using Real = long double;

struct Point {
  Real x = 0, y = 0;
};

// y + y^3 = m.
Real turning_tangent(Real m) {
  Real y = std::abs(m) < 1 ? m : std::cbrt(m);
  for (int k = 0; k < 60; ++k) {
    const Real step = (y + y * y * y - m) / (1 + 3 * y * y);
    y -= step;
    if (std::abs(step) <= std::numeric_limits<Real>::epsilon() * std::abs(y)) break;
  }
  return y;
}

// The moment that is left at the last vertex; the vertices go to `points` when it is given.
Real end_moment(const der::Rod& rod, Real angle, Real load, std::vector<Point>* points = nullptr) {
  const Real EA = rod.section.EA;
  const Real EI = rod.section.EI1;
  Point tangent{std::cos(angle), std::sin(angle)};
  Point at;
  Real moment = 0;
  if (points) points->assign(1, at);
  for (int j = 0; j < rod.edges(); ++j) {
    if (j > 0) {
      const Real v = (Real(rod.rest_lengths[j - 1]) + rod.rest_lengths[j]) / 2;
      const Real y = turning_tangent(moment * v / (2 * EI));
      const Real c = (1 - y * y) / (1 + y * y);
      const Real s = 2 * y / (1 + y * y);
      tangent = {c * tangent.x - s * tangent.y, s * tangent.x + c * tangent.y};
    }
    const Real length = rod.rest_lengths[j] * (1 - load * tangent.x / EA);
    at = {at.x + length * tangent.x, at.y + length * tangent.y};
    moment -= load * length * tangent.y;
    if (points) points->push_back(at);
  }
  return moment;
}

// The smallest load that leaves no moment at the end: no inflection inside.
Real first_load(const der::Rod& rod, Real angle) {
  const Real length = rod.length();
  Real low = 0.1L * rod.section.EI1 / (length * length);
  // The moment vanishes from below: the rod, bent by its own load, turns past its far end.
  Real high = low;
  while (end_moment(rod, angle, high) < 0) {
    low = high;
    high *= 1.1L;
    core::require(std::isfinite(static_cast<double>(high)), "bow: no such shape");
  }
  for (int k = 0; k < 70; ++k) {
    const Real middle = (low + high) / 2;
    (end_moment(rod, angle, middle) < 0 ? low : high) = middle;
  }
  return (low + high) / 2;
}

}  // namespace

Bow bow(const der::Rod& rod, double angle) {
  const Real load = first_load(rod, angle);
  std::vector<Point> points;
  end_moment(rod, angle, load, &points);
  Bow result{.x = Eigen::Matrix3Xd::Zero(3, rod.vertices()),
             .load = static_cast<double>(load),
             .span = static_cast<double>(std::hypot(points.back().x, points.back().y))};
  // The last vertex is off the line by what the bisection left.
  const Real c = points.back().x / result.span;
  const Real s = points.back().y / result.span;
  for (int i = 0; i < rod.vertices(); ++i) {
    result.x(0, i) = static_cast<double>(c * points[i].x + s * points[i].y);
    result.x(1, i) = static_cast<double>(c * points[i].y - s * points[i].x);
  }
  return result;
}

}  // namespace tencer::app::stress
