// Random knots: equilibria of their own springs, the same for a seed, clear of themselves.
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <limits>
#include <tencer/der/section.hpp>
#include <tencer/equilibrium/solve.hpp>
#include <tencer/geometry/measure.hpp>
#include <tencer/random_targets/random_knot.hpp>

using namespace tencer;
using random_targets::RandomKnot;
using random_targets::RandomKnotOptions;

namespace {

RandomKnot knot_of(const RandomKnotOptions& options) {
  auto knot = random_targets::random_knot(options);
  REQUIRE(knot.has_value());
  return *std::move(knot);
}

}  // namespace

TEST_CASE("a seed gives one knot, another seed another") {
  const RandomKnotOptions options{.cables = 5, .length = 100, .vertices = 60, .seed = 7};
  const RandomKnot knot = knot_of(options);
  CHECK(knot.curve.points == knot_of(options).curve.points);
  RandomKnotOptions other = options;
  other.seed = 8;
  CHECK((knot.curve.points - knot_of(other).curve.points).norm() > 1);
}

TEST_CASE("random knots scale with their length") {
  const RandomKnot small = knot_of({.cables = 5, .length = 1, .vertices = 60, .seed = 7});
  const RandomKnot large = knot_of({.cables = 5, .length = 250, .vertices = 60, .seed = 7});
  CHECK((250 * small.curve.points - large.curve.points).norm() < 1e-9 * 250);
}

TEST_CASE("a random knot is the equilibrium of a rod under its springs") {
  const double length = 100;
  const RandomKnot knot = knot_of({.cables = 9, .length = length, .vertices = 80, .seed = 3});
  REQUIRE(knot.cables.size() == 9);
  REQUIRE(knot.curve.closed);
  REQUIRE(knot.curve.vertices() == 80);

  // Unit bending stiffness, and as slender as a glass-fibre rod: EA = 4 EI / radius^2.
  der::Rod rod{.closed = true, .section = {}};
  const double radius = 0.0015 * length;
  rod.section.EA = 4 / (radius * radius);
  rod.rest_lengths = Eigen::VectorXd::Constant(80, length / 80);
  const model::Structure structure{.rods = {rod}, .cables = knot.cables};
  const equilibrium::System system(structure);
  const auto start = model::make_state(structure, {knot.curve.points});
  CHECK(equilibrium::residual(system, start) < 1e-7);
  const auto settled = equilibrium::solve(system, start);
  REQUIRE(settled.usable());
  CHECK(settled.negative == 0);
  CHECK((settled.state[0].x - knot.curve.points).norm() < 1e-5 * length);
}

TEST_CASE("random knots are smooth and keep clear of themselves") {
  const double length = 50;
  const double clearance = 0.01 * length;
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    const RandomKnot knot =
        knot_of({.cables = 14, .length = length, .vertices = 100, .seed = seed});
    CAPTURE(seed);
    CHECK(geometry::edge_lengths(knot.curve).sum() == Approx(length).epsilon(0.01));
    const Eigen::Matrix3Xd edges = geometry::edge_vectors(knot.curve);
    const int n = knot.curve.vertices();
    double nearest = std::numeric_limits<double>::infinity();
    double sharpest = 0;
    for (int i = 0; i < n; ++i) {
      const double cosine = edges.col(i).normalized().dot(edges.col((i + 1) % n).normalized());
      sharpest = std::max(sharpest, std::acos(std::clamp(cosine, -1.0, 1.0)));
      for (int j = i + 1; j < n; ++j)
        if (std::min(j - i, n - (j - i)) > 4)  // farther along the rod than half a circle of 2 cm
          nearest = std::min(nearest, (knot.curve.points.col(i) - knot.curve.points.col(j)).norm());
    }
    CHECK(nearest > clearance);
    // Curvature below 1 / clearance turns an edge by less than its length over the clearance.
    CHECK(sharpest < length / n / clearance);
  }
}

TEST_CASE("what a random knot cannot be made of is said") {
  CHECK_FALSE(random_targets::random_knot_problem({}));
  CHECK(random_targets::random_knot_problem({.cables = 0}));
  CHECK(random_targets::random_knot_problem({.length = -1}));
  CHECK(random_targets::random_knot_problem({.length = std::nan("")}));
  CHECK(random_targets::random_knot_problem({.vertices = 10}));
  CHECK_THROWS_AS(random_targets::random_knot({.cables = 0}), std::invalid_argument);
}

TEST_CASE("no knot when no draw will do") {
  // A rod of length 1 cannot curve with a radius of 0.099 and hold clear of itself in three
  // dimensions within one draw of this seed.
  CHECK_FALSE(random_targets::random_knot(
      {.cables = 20, .vertices = 60, .seed = 1, .clearance = 0.099, .draws = 1}));
}
