#include <catch2/catch.hpp>
#include <cmath>
#include <tencer/curves/families.hpp>
#include <tencer/geometry/measure.hpp>
#include <tencer/geometry/sampling.hpp>

using namespace tencer::geometry;
using namespace tencer::curves;

namespace {

// Without the tabulated knots, which take their time and have tests of their own.
std::vector<Family> analytic_families() {
  std::vector<Family> list = families();
  std::erase_if(list, [](const Family& family) { return family.name.starts_with("knot-"); });
  return list;
}

std::vector<double> standard(const Family& family) {
  std::vector<double> values;
  for (const FamilyParameter& parameter : family.parameters) values.push_back(parameter.standard);
  return values;
}

}  // namespace

TEST_CASE("every family is sampled evenly and smoothly, also across the seam") {
  for (const Family& family : analytic_families()) {
    CAPTURE(family.name);
    const std::vector<double> values = standard(family);
    REQUIRE_FALSE(family_problem(family, values, family.vertices));
    for (const Polyline& curve : family_curves(family, values, 800)) {
      REQUIRE(curve.vertices() == 800);
      REQUIRE(curve.closed == (family.name != "helix"));
      const Eigen::VectorXd lengths = edge_lengths(curve);
      // Equal arcs: the chords differ by their curvature only.
      CHECK(lengths.maxCoeff() / lengths.minCoeff() < 1.001);
      const Eigen::Matrix3Xd edges = edge_vectors(curve);
      for (int i = 0; i < curve.edges() - (curve.closed ? 0 : 1); ++i) {
        const Eigen::Vector3d next = edges.col((i + 1) % curve.edges());
        REQUIRE(edges.col(i).dot(next) > 0.995 * edges.col(i).norm() * next.norm());
      }
    }
  }
}

TEST_CASE("no family crosses itself with its default parameters") {
  for (const Family& family : analytic_families()) {
    CAPTURE(family.name);
    const auto curves = family_curves(family, standard(family), family.vertices);
    CHECK(closest_approach(curves)->distance > 0.001 * bounding_box_diagonal(curves));
    for (const Polyline& curve : curves) {
      // Neighbouring edges but one are close as well: look at every fourth vertex only.
      const std::vector<Polyline> coarse{resample(curve, curve.vertices() / 4)};
      CHECK(closest_approach(coarse)->distance > 0.02 * bounding_box_diagonal(coarse));
    }
  }
}

TEST_CASE("unusable family parameters are named") {
  const auto problem = [](std::string_view name, std::vector<double> values, int vertices = 100) {
    for (const Family& family : families())
      if (family.name == name) return family_problem(family, values, vertices).value_or("");
    return std::string("no such family");
  };
  CHECK(problem("circle", {0}) == "radius must be a positive number");
  CHECK(problem("circle", {std::nan("")}) == "radius must be a positive number");
  CHECK(problem("circle", {1}, 2) == "vertices must be at least 3");
  CHECK(problem("circle", {1}, 1000001) == "vertices must be at most 1000000");
  CHECK(problem("torus-knot", {2.5, 3, 2, 1}) == "p must be a whole number from 1 to 1000");
  CHECK(problem("torus-knot", {4, 2, 2, 1}) ==
        "p and q must have no common divisor, or the curve is traced several times");
  CHECK(problem("torus-knot", {2, 3, 1, 1}) == "major must be larger than minor");
  CHECK(problem("twin-trefoils", {1, 2}) == "major must be larger than minor");
  CHECK(problem("borromean-ellipses", {5, 5}) == "long_axis must be larger than short_axis");
  CHECK(problem("helix", {50, 33, 1.5}) == "");
}
