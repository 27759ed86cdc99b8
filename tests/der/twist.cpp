// Twist against closed forms, and the three models against each other where they describe the same
// rod.
#include <Eigen/Dense>
#include <catch2/catch.hpp>
#include <numbers>

#include "fixtures.hpp"

using namespace tencer::der;
using std::numbers::pi;

namespace {

constexpr int vertices = 12;

Rod ring_rod() {
  return {.closed = true,
          .section = {.EA = 30.0, .EI1 = 1.3, .EI2 = 1.3, .GJ = 0.9},
          .rest_lengths =
              Eigen::VectorXd::Constant(vertices, 1.0) + 0.3 * Eigen::VectorXd::Random(vertices),
          .closing_angle = 2.5};
}

// The material frame at rest relative to given positions: a linear problem in theta, of which one
// may be chosen.
void relax_theta(const Rod& rod, RodState& state) {
  const int first = 3 * rod.vertices() + 1;
  const int count = rod.edges() - 1;
  Eigen::VectorXd step = Eigen::VectorXd::Zero(unknowns(rod));
  step.segment(first, count) = -dense_hessian(rod, state)
                                    .block(first, first, count, count)
                                    .ldlt()
                                    .solve(gradient(rod, state).segment(first, count));
  displace(rod, state, step);
}

// A closed curve that winds `coils` times around a circle, at distance `depth` from it.
Eigen::Matrix3Xd coil(int n, int coils, double depth) {
  Eigen::Matrix3Xd x(3, n);
  for (int i = 0; i < n; ++i) {
    const double phi = 2 * pi * i / n;
    const double r = 2 + depth * std::cos(coils * phi);
    x.col(i) << r * std::cos(phi), r * std::sin(phi), depth * std::sin(coils * phi);
  }
  return x;
}

}  // namespace

TEST_CASE("uniform twist is per-edge twist with the angles at rest") {
  std::srand(5);
  Rod uniform = ring_rod();
  uniform.rest_twist = 0.2 * Eigen::VectorXd::Random(vertices);
  Rod framed = uniform;
  force_per_edge(framed);
  REQUIRE(twist_model(uniform) == TwistModel::uniform);
  REQUIRE(twist_model(framed) == TwistModel::per_edge);

  // Displaced the same way from the same start, with angles anywhere on the way.
  Eigen::VectorXd step = 0.3 * Eigen::VectorXd::Random(unknowns(framed));
  RodState a = make_state(uniform, coil(vertices, 3, 0.4));
  RodState b = make_state(framed, a.x);
  CHECK(energy(framed, b) == Approx(energy(uniform, a)).epsilon(1e-12));
  displace(framed, b, step);
  displace(uniform, a, step.head(unknowns(uniform)));
  CHECK(energy(framed, b) > energy(uniform, a) + 0.01);
  CHECK(-b.frames.twist.sum() == Approx(a.holonomy).epsilon(1e-12));

  relax_theta(framed, b);
  CHECK(energy(framed, b) == Approx(energy(uniform, a)).epsilon(1e-12));
  const Eigen::VectorXd g = gradient(framed, b);
  CHECK(g.tail(vertices).norm() < 1e-12 * g.norm());
  CHECK((g.head(3 * vertices) - gradient(uniform, a).head(3 * vertices)).norm() < 1e-12 * g.norm());
  CHECK(gradient(uniform, a)[3 * vertices] == 0.0);

  // Eliminating theta leaves the Hessian that eliminating the moment leaves.
  const Eigen::MatrixXd h = dense_hessian(framed, b);
  const int p = 3 * vertices;
  const int k = vertices - 1;
  const Eigen::MatrixXd reduced =
      h.topLeftCorner(p, p) -
      h.topRightCorner(p, k) * h.bottomRightCorner(k, k).ldlt().solve(h.bottomLeftCorner(k, p));
  CHECK((reduced - energy_hessian(uniform, a)).norm() < 1e-11 * h.norm());
}

TEST_CASE("one negative pivot belongs to the twisting moment") {
  std::srand(6);
  const Rod rod = ring_rod();
  const RodState state = random_state(rod);
  const Eigen::MatrixXd h = dense_hessian(rod, state);
  CHECK(h(3 * vertices, 3 * vertices) == Approx(-rod.length() / rod.section.GJ));
}

TEST_CASE("without twist an isotropic straight rod does not see its frames") {
  std::srand(7);
  Rod plain{.closed = GENERATE(false, true), .section = {.EA = 30.0, .EI1 = 1.3, .EI2 = 1.3}};
  plain.rest_lengths = Eigen::VectorXd::Constant(plain.closed ? vertices : vertices - 1, 1.0);
  Rod framed = plain;
  framed.section.GJ = 1e-300;
  force_per_edge(framed);
  const RodState a = random_state(plain);
  RodState b = make_state(framed, a.x);
  b.theta.setRandom();
  CHECK(energy(framed, b) == Approx(energy(plain, a)).epsilon(1e-13));
  const Eigen::VectorXd g = gradient(framed, b);
  const int p = 3 * vertices;
  CHECK((g.head(p) - gradient(plain, a)).norm() < 1e-13 * g.norm());
  CHECK(g.tail(framed.edges()).norm() < 1e-13 * g.norm());
  const Eigen::MatrixXd h = dense_hessian(framed, b);
  CHECK((h.topLeftCorner(p, p) - dense_hessian(plain, a)).norm() < 1e-13 * h.norm());
  CHECK(h.rightCols(framed.edges()).norm() < 1e-13 * h.norm());
}

TEST_CASE("an even twist of a straight rod costs GJ angle^2 / (2 L)") {
  const int edges = 10;
  Rod rod{.section = {.EA = 1.0, .EI1 = 2.0, .EI2 = 2.0, .GJ = 0.7},
          .rest_lengths = Eigen::VectorXd::Constant(edges, 0.5),
          .clamp_start_frame = true,
          .clamp_end_frame = true};
  Eigen::Matrix3Xd x = Eigen::Matrix3Xd::Zero(3, edges + 1);
  x.row(2).setLinSpaced(0.0, 0.5 * edges);
  RodState state = make_state(rod, x);
  CHECK(energy(rod, state) == 0.0);
  const double angle = 7.0;
  state.theta.setLinSpaced(0.0, angle);
  // The frames are those of edge midpoints.
  CHECK(energy(rod, state) == Approx(0.7 * angle * angle / (2 * 0.5 * (edges - 1))));
  Eigen::VectorXd g = gradient(rod, state);
  CHECK(g[3 * (edges + 1)] == Approx(-0.7 * angle / (0.5 * (edges - 1))));
  CHECK(g[3 * (edges + 1) + edges - 1] == Approx(0.7 * angle / (0.5 * (edges - 1))));
  g.tail(edges)[0] = g.tail(edges)[edges - 1] = 0;
  CHECK(g.norm() < 1e-13);
}

TEST_CASE("a flat ring is untwisted at closing angle 0, and a full turn costs what it should") {
  std::srand(8);
  Rod rod = ring_rod();
  if (GENERATE(false, true)) force_per_edge(rod);
  const Eigen::Matrix3Xd x = coil(vertices, 0, 0.5);
  rod.closing_angle = 0.0;
  const double flat = energy(rod, make_state(rod, x));
  rod.closing_angle = 2 * pi;
  CHECK(energy(rod, make_state(rod, x)) - flat ==
        Approx(0.9 * 4 * pi * pi / (2 * rod.length())).epsilon(1e-12));
}

TEST_CASE("a free closing angle transmits no twisting moment across the seam") {
  std::srand(9);
  Rod rod = ring_rod();
  rod.closing_angle.reset();
  rod.section.EI2 = 0.5;
  RodState state = make_state(rod, coil(vertices, 3, 0.4));
  const auto twisting_energy = [&] {
    Rod stiffer = rod;
    stiffer.section.GJ += 1;
    return energy(stiffer, state) - energy(rod, state);
  };
  CHECK(twisting_energy() < 1e-14);
  state.theta += Eigen::VectorXd::LinSpaced(vertices, 0.0, 1.0);
  double expected = 0;
  for (int b = 1; b < vertices; ++b)
    expected +=
        1.0 / (vertices - 1) / (vertices - 1) / (rod.rest_lengths[b - 1] + rod.rest_lengths[b]);
  CHECK(twisting_energy() == Approx(expected).epsilon(1e-10));
}

TEST_CASE("holonomy and reference twist count full turns along a motion") {
  // Winding a ring into a coil of four windings turns its untwisted frame by several radians; the
  // solid angle of the tangent gives the holonomy up to full turns only.
  const int n = 120;
  Rod uniform{.closed = true, .section = {}, .rest_lengths = Eigen::VectorXd::Constant(n, 0.1)};
  uniform.closing_angle = 0.0;
  Rod framed = uniform;
  force_per_edge(framed);
  RodState a = make_state(uniform, coil(n, 4, 0.0));
  RodState b = make_state(framed, a.x);
  CHECK(std::abs(a.holonomy) < 1e-12);
  const int steps = GENERATE(4, 50);
  for (int k = 1; k <= steps; ++k) {
    Eigen::VectorXd step = Eigen::VectorXd::Zero(unknowns(framed));
    step.head(3 * n) = (coil(n, 4, 0.9 * k / steps) - a.x).reshaped();
    displace(uniform, a, step.head(unknowns(uniform)));
    displace(framed, b, step);
  }
  CHECK(std::abs(a.holonomy) > 4);
  CHECK(-b.frames.twist.sum() == Approx(a.holonomy).epsilon(1e-12));
  const double fresh = make_state(uniform, a.x).holonomy;
  CHECK(std::abs(std::remainder(a.holonomy - fresh, 2 * pi)) < 1e-11);
  // And back.
  Eigen::VectorXd step = Eigen::VectorXd::Zero(unknowns(uniform));
  step.head(3 * n) = (coil(n, 4, 0.0) - a.x).reshaped();
  displace(uniform, a, step);
  CHECK(std::abs(a.holonomy) < 1e-11);
}
