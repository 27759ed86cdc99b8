#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>
#include <tencer/curves/repulsion.hpp>

#include "tangent_point.hpp"
#include "unknot.hpp"

using namespace tencer;
using namespace tencer::curves;
using geometry::Polyline;
using std::numbers::pi;

TEST_CASE("an unknot comes to rest as a circle") {
  const Repelled rest = repel(test::unknot(60));
  CHECK(rest.converged);
  CHECK(rest.energy == Approx(tangent_point_energy(rest.curve).energy).epsilon(1e-12));
  CHECK(edge_lengths(rest.curve).sum() == Approx(1));
  const Eigen::RowVectorXd radii = rest.curve.points.colwise().norm();
  CHECK(radii.maxCoeff() / radii.minCoeff() < 1.02);
}

TEST_CASE("repulsion does not start from a curve that crosses itself") {
  Polyline eight{Eigen::Matrix3Xd(3, 16), true};
  for (int i = 0; i < 16; ++i) eight.points.col(i) << std::sin(pi * i / 8), std::sin(pi * i / 4), 0;
  CHECK_THROWS_AS(repel(eight), std::invalid_argument);
}

TEST_CASE("options of the repulsion that make no sense are named") {
  const Polyline curve = test::unknot(12);
  CHECK_THROWS_WITH(repel(curve, {.max_iterations = -1}),
                    "RepelOptions: max_iterations must not be negative");
  CHECK_THROWS_WITH(repel(curve, {.min_decrease = std::nan("")}),
                    "RepelOptions: min_decrease must not be negative");
  CHECK_THROWS_WITH(repel(curve, {.patience = 0}), "RepelOptions: patience must be positive");
  CHECK(repel(curve, {.max_iterations = 0}).iterations == 0);
}
