#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>
#include <tencer/der/curvature.hpp>

using namespace tencer::der;

namespace {

// An arc of this radius in the xy plane, its centre at the origin, with `edges` chords of one
// angle.
Eigen::Matrix3Xd arc(double radius, double angle, int edges) {
  Eigen::Matrix3Xd x(3, edges + 1);
  for (int i = 0; i <= edges; ++i)
    x.col(i) << radius * std::cos(i * angle), radius * std::sin(i * angle), 0.0;
  return x;
}

Rod rod_of(const Section& section, int edges, double length) {
  return {.section = section, .rest_lengths = Eigen::VectorXd::Constant(edges, length)};
}

}  // namespace

TEST_CASE("a rod on a circle is bent by one over its radius") {
  constexpr int edges = 12;
  constexpr double radius = 3.0;
  constexpr double angle = 1e-3;
  const double chord = 2 * radius * std::sin(angle / 2);
  const Rod rod = rod_of({}, edges, chord);
  const auto bent = bending_curvature(rod, make_state(rod, arc(radius, angle, edges)));
  REQUIRE(bent.cols() == edges - 1);
  CHECK((bent.row(0).array() - 1 / radius).abs().maxCoeff() < 1e-6);
  CHECK(bent.row(1).isZero(0));
}

TEST_CASE("a strip tells towards which of its axes it is bent, and counts from rest") {
  constexpr int edges = 12;
  constexpr double radius = 3.0;
  constexpr double angle = 1e-3;
  Rod rod = rod_of(rectangle(1.0, 0.3, 0.1, 0.4), edges, 2 * radius * std::sin(angle / 2));
  RodState state = make_state(rod, arc(radius, angle, edges));
  for (int j = 0; j < edges; ++j) set_material_frame(state, j, Eigen::Vector3d::UnitZ());
  const auto flat = bending_curvature(rod, state);
  CHECK(flat.row(0).cwiseAbs().maxCoeff() < 1e-9);
  CHECK((flat.row(1).cwiseAbs().array() - 1 / radius).abs().maxCoeff() < 1e-6);

  Eigen::Matrix3Xd up(3, edges);
  up.colwise() = Eigen::Vector3d::UnitZ();
  set_rest_shape(rod, state.x, up);
  CHECK(bending_curvature(rod, state).cwiseAbs().maxCoeff() < 1e-9);
}
