// Figure 8: a ring whose diameter is shortened by a cable leaves its plane.
#include <Eigen/Eigenvalues>
#include <catch2/catch.hpp>
#include <tencer/equilibrium/inextensible.hpp>
#include <tencer/equilibrium/solve.hpp>
#include <tencer/equilibrium/stability.hpp>

#include "models.hpp"

using namespace tencer;
using namespace tencer::equilibrium;

namespace {

constexpr int vertices = 60;
const double diameter = 1 / std::numbers::pi;

// The planar equilibrium with a cable of the given length.
InextensibleEquilibrium planar_ring(double length) {
  model::Structure ring = models::ring_with_cable(vertices, 1.0, length);
  ring.planar = true;
  return relax_inextensible(ring, model::make_state(ring, {models::polygon(vertices, 1.0)}));
}

Stability out_of_plane(double length) {
  const InextensibleEquilibrium flat = planar_ring(length);
  REQUIRE(flat.equilibrium.usable());
  const model::Structure ring = models::ring_with_cable(vertices, 1.0, length);
  return assess(ring, flat.equilibrium.state, flat.tensions).stability;
}

}  // namespace

TEST_CASE("a ring stays in its plane until the cable is short") {
  CHECK(out_of_plane(0.97 * diameter).stable());
  CHECK(out_of_plane(0.42 * diameter).stable());
  CHECK(out_of_plane(0.32 * diameter).negative == 1);
}

TEST_CASE("a ring with a short cable is unstable in its plane and stable out of it") {
  const double length = 0.25 * diameter;
  CHECK(planar_ring(length).equilibrium.usable());
  const Stability flat = out_of_plane(length);
  CHECK(flat.negative > 0);
  CHECK(flat.smallest_eigenvalue < 0);
  CHECK_FALSE(flat.stable());

  // From the planar state itself, which is a saddle, Newton's method must leave the plane.
  const model::Structure ring = models::ring_with_cable(vertices, 1.0, length);
  const InextensibleEquilibrium start = planar_ring(length);
  const InextensibleEquilibrium bent = relax_inextensible(ring, start.equilibrium.state);
  REQUIRE(bent.equilibrium.usable());
  CHECK(bent.equilibrium.escapes > 0);
  const auto& x = bent.equilibrium.state[0].x;
  const Eigen::Vector3d centre = x.rowwise().mean();
  const Eigen::Matrix3Xd arms = x.colwise() - centre;
  const Eigen::Matrix3d scatter = arms * arms.transpose();
  const Eigen::Vector3d thickness =
      Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(scatter).eigenvalues();
  CHECK(std::sqrt(thickness[0] / vertices) > 0.02);
  const Assessment assessment = assess(ring, bent.equilibrium.state, bent.tensions);
  CHECK(assessment.certified());
}

TEST_CASE("the planar branch follows the elastica's symmetry") {
  // Both halves carry the same load, so the cable's tension is twice an edge's compression there.
  const InextensibleEquilibrium flat = planar_ring(0.7 * diameter);
  REQUIRE(flat.equilibrium.usable());
  const model::Structure ring = models::ring_with_cable(vertices, 1.0, 0.7 * diameter);
  const System system(ring);
  const auto axial = system.internal_forces(flat.equilibrium.state).axial[0];
  CHECK((axial.head(vertices / 2) - axial.tail(vertices / 2)).norm() < 1e-5 * axial.norm());
}
