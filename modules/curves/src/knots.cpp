#include <tencer/core/error.hpp>
#include <tencer/curves/braid.hpp>
#include <tencer/curves/knots.hpp>
#include <tencer/curves/repulsion.hpp>
#include <tencer/geometry/spline.hpp>

namespace tencer::curves {

using geometry::Polyline;

namespace {

// Enough for seven crossings, and as many for all, so that the number of vertices asked for does
// not change the shape.
constexpr int working_vertices = 240;

// A bent space: what looks the same from several sides would otherwise rest, by symmetry, on a
// saddle of the energy. Every knot stays what it is.
void bend(Polyline& curve) {
  const double size = curve.points.row(0).maxCoeff();
  for (auto point : curve.points.colwise()) {
    const double x = (point.x() + 0.5 * point.y()) / size;
    point.x() *= 1.1;
    point.z() += 0.1 * size * x * (1 + x);
  }
}

}  // namespace

std::vector<KnotBraid> knot_table() {
  return {{"3_1", 2, {1, 1, 1}},
          {"4_1", 3, {1, -2, 1, -2}},
          {"5_1", 2, {1, 1, 1, 1, 1}},
          {"5_2", 3, {1, 1, 1, 2, -1, 2}},
          {"6_1", 4, {1, 1, 2, -1, -3, 2, -3}},
          {"6_2", 3, {1, 1, 1, -2, 1, -2}},
          {"6_3", 3, {1, 1, -2, 1, -2, -2}},
          {"7_1", 2, {1, 1, 1, 1, 1, 1, 1}},
          {"7_2", 4, {1, 1, 1, 2, -1, 2, 3, -2, 3}},
          {"7_3", 3, {1, 1, 1, 1, 1, 2, -1, 2}},
          {"7_4", 4, {1, 1, 2, -1, 2, 2, 3, -2, 3}},
          {"7_5", 3, {1, 1, 1, 1, 2, -1, 2, 2}},
          {"7_6", 4, {1, 1, -2, 1, 3, -2, 3}},
          {"7_7", 4, {1, -2, 1, -2, 3, -2, 3}}};
}

Polyline knot(const KnotBraid& braid, double length, int vertices) {
  core::require(length > 0 && vertices >= 3, "knot: needs a positive length and three vertices");
  Polyline start = geometry::resample(braid_closure(braid.strands, braid.word), working_vertices);
  bend(start);
  const Polyline rest = repel(start).curve;
  Polyline curve = geometry::sample_spline(rest, vertices);
  curve.points *=
      length / geometry::length(geometry::spline(rest), 0, geometry::edge_lengths(rest).sum());
  return curve;
}

}  // namespace tencer::curves
