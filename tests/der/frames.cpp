#include <Eigen/Geometry>
#include <catch2/catch.hpp>
#include <numbers>

#include "fixtures.hpp"

using namespace tencer::der;

namespace {

Rod strip(bool closed, int vertices) {
  const int edges = closed ? vertices : vertices - 1;
  return {.closed = closed,
          .section = {.EA = 30.0, .EI1 = 1.3, .EI2 = 0.4, .GJ = 0.9},
          .rest_lengths = Eigen::VectorXd::Constant(edges, 1.0)};
}

}  // namespace

TEST_CASE("frames stay orthonormal and true to the edges over 1000 displacements") {
  std::srand(11);
  const Rod rod = strip(true, 10);
  RodState state = random_state(rod);
  const Eigen::VectorXd start = state.x.reshaped();
  for (int k = 0; k < 1000; ++k) {
    // Always a random distance from the same curve, so that it never collapses.
    Eigen::VectorXd step = 0.3 * Eigen::VectorXd::Random(unknowns(rod));
    step.head(start.size()) += start - Eigen::VectorXd(state.x.reshaped());
    displace(rod, state, step);
  }
  for (int j = 0; j < rod.edges(); ++j) {
    const Eigen::Vector3d e = state.x.col((j + 1) % rod.vertices()) - state.x.col(j);
    const Eigen::Matrix3d frame = material_frame(state, j);
    CHECK((frame.transpose() * frame - Eigen::Matrix3d::Identity()).norm() < 1e-14);
    CHECK(frame.determinant() == Approx(1.0));
    CHECK((frame.col(2) - e.normalized()).norm() < 1e-14);
  }
}

TEST_CASE("the energy does not depend on the choice of reference frames") {
  std::srand(12);
  for (const auto& [name, rod] : rods_of_every_model(9)) {
    if (twist_model(rod) != TwistModel::per_edge) continue;
    INFO(name);
    const RodState state = random_state(rod);
    RodState other = state;
    const Eigen::VectorXd turn = 3 * Eigen::VectorXd::Random(rod.edges());
    other.theta -= turn;
    for (int j = 0; j < rod.edges(); ++j)
      other.frames.director.col(j) =
          Eigen::AngleAxisd(turn[j], Eigen::Vector3d(state.frames.tangent.col(j))) *
          state.frames.director.col(j);
    for (int b = 0; b < rod.bending_vertices(); ++b) {
      const int after = rod.bending_vertex(b);
      const int before = (after + rod.edges() - 1) % rod.edges();
      other.frames.twist[b] += turn[after] - turn[before];
    }
    CHECK(energy(rod, other) == Approx(energy(rod, state)).epsilon(1e-12));
    const Eigen::VectorXd g = gradient(rod, state);
    CHECK((gradient(rod, other) - g).norm() < 1e-12 * g.norm());
    // Nor afterwards.
    const Eigen::VectorXd step = 0.2 * Eigen::VectorXd::Random(unknowns(rod));
    CHECK(energy(rod, moved(rod, other, step)) ==
          Approx(energy(rod, moved(rod, state, step))).epsilon(1e-12));
  }
}

TEST_CASE("displacing turns frames by the least rotation and theta") {
  const Rod rod = strip(false, 3);
  Eigen::Matrix3Xd x(3, 3);
  x << 0, 1, 2, 0, 0, 0, 0, 0, 0;
  RodState state = make_state(rod, x);
  set_material_frame(state, 0, Eigen::Vector3d::UnitY());
  set_material_frame(state, 1, Eigen::Vector3d(5.0, 1.0, 1.0));
  CHECK((material_frame(state, 0) - (Eigen::Matrix3d() << 0, 0, 1, 1, 0, 0, 0, 1, 0).finished())
            .norm() < 1e-15);
  CHECK((material_frame(state, 1).col(0) - Eigen::Vector3d(0, 1, 1).normalized()).norm() < 1e-15);

  // A quarter turn about z takes the second edge to y; z, on the axis, stays.
  set_material_frame(state, 1, Eigen::Vector3d::UnitZ());
  Eigen::VectorXd step = Eigen::VectorXd::Zero(unknowns(rod));
  step.segment<3>(6) << -1, 1, 0;
  displace(rod, state, step);
  CHECK((material_frame(state, 1).col(0) - Eigen::Vector3d::UnitZ()).norm() < 1e-15);
  step.setZero();
  step[10] = std::numbers::pi / 2;
  displace(rod, state, step);
  CHECK((material_frame(state, 1).col(0) - Eigen::Vector3d::UnitX()).norm() < 1e-15);

  CHECK_THROWS_WITH(set_material_frame(state, 1, Eigen::Vector3d::UnitY()),
                    Catch::Contains("along the edge"));
  CHECK_THROWS_AS(material_frame(state, 2), std::invalid_argument);
}

TEST_CASE("an edge may turn right round in one step") {
  const Rod rod = strip(false, 3);
  Eigen::Matrix3Xd x(3, 3);
  x << 0, 1, 2, 0, 0, 1, 0, 0, 0;
  RodState state = make_state(rod, x);
  const double before = energy(rod, state);
  Eigen::VectorXd step = Eigen::VectorXd::Zero(unknowns(rod));
  step.head(9) = -2 * x.reshaped();
  displace(rod, state, step);
  CHECK(state.frames.director.allFinite());
  CHECK(
      (state.frames.director.array() * state.frames.tangent.array()).colwise().sum().isZero(1e-15));
  CHECK(std::isfinite(before));
  CHECK(std::isfinite(energy(rod, state)));
}
