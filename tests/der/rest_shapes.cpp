#include <Eigen/Geometry>
#include <catch2/catch.hpp>
#include <numbers>

#include "fixtures.hpp"

using namespace tencer::der;
using std::numbers::pi;

namespace {

Eigen::Matrix3Xd circle(int n, double radius) {
  Eigen::Matrix3Xd x(3, n);
  for (int i = 0; i < n; ++i)
    x.col(i) << radius * std::cos(2 * pi * i / n), radius * std::sin(2 * pi * i / n), 0;
  return x;
}

Eigen::VectorXd edge_lengths(const Eigen::Matrix3Xd& x, bool closed) {
  const auto n = x.cols();
  Eigen::VectorXd lengths(closed ? n : n - 1);
  for (int j = 0; j < lengths.size(); ++j) lengths[j] = (x.col((j + 1) % n) - x.col(j)).norm();
  return lengths;
}

Eigen::Matrix3Xd helix(int n) {
  Eigen::Matrix3Xd x(3, n);
  for (int i = 0; i < n; ++i) x.col(i) << std::cos(0.4 * i), std::sin(0.4 * i), 0.07 * i;
  return x;
}

}  // namespace

TEST_CASE("the energy of a circle tends to pi EI / R with the square of the edge length") {
  const double radius = 1.7;
  double errors[2];
  for (int k = 0; k < 2; ++k) {
    const Eigen::Matrix3Xd x = circle(50 << k, radius);
    const Rod rod{.closed = true,
                  .section = {.EA = 100.0, .EI1 = 0.6, .EI2 = 0.6, .GJ = 1.0},
                  .rest_lengths = edge_lengths(x, true)};
    errors[k] = energy(rod, make_state(rod, x)) - pi * 0.6 / radius;
  }
  CHECK(std::abs(errors[1]) < 1e-3);
  CHECK(errors[0] / errors[1] == Approx(4.0).epsilon(0.01));
}

TEST_CASE("a strip bends about its weak axis more easily") {
  // Thin along m1, so it bends easily towards m1, which is about m2.
  const Section section = rectangle(1000.0, 0.3, 0.1, 0.4);
  REQUIRE(section.EI2 == Approx(section.EI1 / 16));
  const Eigen::Matrix3Xd x = circle(40, 2.0);
  // tilt: of m1 out of the plane of the circle.
  const auto bent = [&](const Section& s, double tilt) {
    const Rod rod{.closed = true, .section = s, .rest_lengths = edge_lengths(x, true)};
    RodState state = make_state(rod, x);
    for (int j = 0; j < state.theta.size(); ++j) {
      const Eigen::Vector3d t = state.frames.tangent.col(j);
      set_material_frame(state, j,
                         std::sin(tilt) * Eigen::Vector3d::UnitZ() +
                             std::cos(tilt) * t.cross(Eigen::Vector3d::UnitZ()));
    }
    return energy(rod, state);
  };
  const auto isotropic = [](double EI) {
    return Section{.EA = 1.0, .EI1 = EI, .EI2 = EI, .GJ = 1.0};
  };
  const double easy = bent(isotropic(section.EI2), 0.0);
  const double hard = bent(isotropic(section.EI1), 0.0);
  CHECK(bent(section, 0.0) == Approx(easy).epsilon(1e-12));
  CHECK(bent(section, pi / 2) == Approx(hard).epsilon(1e-12));
  CHECK(
      bent(section, 0.7) ==
      Approx(easy * std::pow(std::cos(0.7), 2) + hard * std::pow(std::sin(0.7), 2)).epsilon(1e-12));
}

TEST_CASE("a rod is without energy in its rest shape, whatever its material frames") {
  std::srand(21);
  const bool closed = GENERATE(false, true);
  const int n = 15;
  Eigen::Matrix3Xd x = helix(n);
  if (closed) x = circle(n, 2.0) + 0.3 * Eigen::Matrix3Xd::Random(3, n);
  Rod rod{.closed = closed, .section = {.EA = 50.0, .EI1 = 1.3, .EI2 = 0.4, .GJ = 0.9}};
  const Eigen::Matrix3Xd m1 = Eigen::Matrix3Xd::Random(3, closed ? n : n - 1);
  set_rest_shape(rod, x, m1);
  validate(rod);
  RodState state = make_state(rod, x);

  if (!closed) {
    // make_state lets the rest twist decide all frames but the first.
    RodState turned = state;
    set_material_frame(turned, 0, m1.col(0));
    turned.theta.tail(rod.edges() - 1).array() += turned.theta[0] - state.theta[0];
    CHECK(energy(rod, turned) < 1e-26);
  }

  // Set frame by frame, the twist is the rest twist up to full turns; those are taken out, at the
  // seam by the closing angle.
  for (int j = 0; j < rod.edges(); ++j) set_material_frame(state, j, m1.col(j));
  const auto excess = [&](int b) {
    const int after = rod.bending_vertex(b);
    const int before = (after + rod.edges() - 1) % rod.edges();
    const double angle =
        state.theta[after] - state.theta[before] + state.frames.twist[b] - rod.rest_twist[b];
    CHECK(std::abs(std::remainder(angle, 2 * pi)) < 1e-13);
    return angle;
  };
  for (int b = closed ? 1 : 0; b < rod.bending_vertices(); ++b)
    state.theta[rod.bending_vertex(b)] -= excess(b);
  if (closed) rod.closing_angle = -excess(0);
  CHECK(energy(rod, state) < 1e-26);
  CHECK(gradient(rod, state).norm() < 1e-12);
}

TEST_CASE("a rod twisted at rest starts out twisted") {
  std::srand(22);
  const int n = 12;
  Eigen::Matrix3Xd x = Eigen::Matrix3Xd::Zero(3, n);
  x.row(0).setLinSpaced(0.0, n - 1.0);
  Rod rod{.section = {.EA = 50.0, .EI1 = 1.3, .EI2 = 0.4, .GJ = 0.9},
          .rest_lengths = Eigen::VectorXd::Ones(n - 1),
          .rest_twist = Eigen::VectorXd::Random(n - 2)};
  RodState state = make_state(rod, x);
  CHECK(energy(rod, state) < 1e-28);
  CHECK(state.theta[n - 2] == Approx(rod.rest_twist.sum()));
  state.theta.setZero();
  CHECK(energy(rod, state) == Approx(0.9 / 2 * rod.rest_twist.squaredNorm()));
}

TEST_CASE("which twist a rod needs") {
  Rod rod{.closed = true, .section = {}, .rest_lengths = Eigen::VectorXd::Ones(5)};
  CHECK(twist_model(rod) == TwistModel::none);
  rod.rest_twist = Eigen::VectorXd::Ones(5);
  CHECK(twist_model(rod) == TwistModel::none);
  rod.closing_angle = 0.0;
  CHECK(twist_model(rod) == TwistModel::uniform);
  rod.rest_curvature = Eigen::Matrix2Xd::Zero(2, 5);
  CHECK(twist_model(rod) == TwistModel::uniform);
  rod.rest_curvature(0, 0) = 0.1;
  CHECK(twist_model(rod) == TwistModel::per_edge);
  rod.rest_curvature.resize(2, 0);
  rod.section.EI2 = 2.0;
  CHECK(twist_model(rod) == TwistModel::per_edge);

  Rod open{.section = {}, .rest_lengths = Eigen::VectorXd::Ones(5)};
  open.clamp_start_frame = true;
  CHECK(twist_model(open) == TwistModel::none);
  open.clamp_end_frame = true;
  CHECK(twist_model(open) == TwistModel::per_edge);
}

TEST_CASE("a rod that cannot be is refused by the name of the field") {
  const Rod good{.closed = true, .section = {}, .rest_lengths = Eigen::VectorXd::Ones(5)};
  CHECK_NOTHROW(validate(good));
  const auto refused = [&](auto change, const char* name) {
    Rod rod = good;
    change(rod);
    CHECK_THROWS_WITH(validate(rod), Catch::Contains(name));
  };
  refused([](Rod& r) { r.rest_lengths.conservativeResize(2); }, "3 edges");
  refused([](Rod& r) { r.rest_lengths[2] = 0; }, "rest_lengths");
  refused([](Rod& r) { r.rest_lengths[2] = NAN; }, "rest_lengths");
  refused([](Rod& r) { r.section.GJ = -1; }, "GJ");
  refused([](Rod& r) { r.section.EI2 = INFINITY; }, "EI");
  refused([](Rod& r) { r.rest_curvature = Eigen::Matrix2Xd::Zero(2, 3); }, "rest_curvature");
  refused([](Rod& r) { r.rest_twist = Eigen::VectorXd::Zero(4); }, "rest_twist");
  refused([](Rod& r) { r.closing_angle = NAN; }, "closing_angle");
  refused([](Rod& r) { r.closed = false, r.closing_angle = 1.0; }, "closing_angle");
  refused([](Rod& r) { r.clamp_end_frame = true; }, "open");
}
