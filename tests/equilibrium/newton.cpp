#include <Eigen/Geometry>
#include <catch2/catch.hpp>
#include <tencer/equilibrium/solve.hpp>
#include <tencer/equilibrium/stability.hpp>

#include "eigenvalues.hpp"
#include "models.hpp"

using namespace tencer;
using namespace tencer::equilibrium;

namespace {

Eigen::MatrixXd dense(const linalg::SymmetricMatrix& lower) {
  return Eigen::MatrixXd(lower).selfadjointView<Eigen::Lower>();
}

Eigen::MatrixXd dense_hessian(const System& system, const model::State& state) {
  linalg::SymmetricMatrix matrix = system.pattern();
  system.hessian(state, system.internal_forces(state), matrix);
  return dense(matrix);
}

// Two linked rings with zero-length cables between them and one within the first.
model::Structure linked_rings() {
  model::Structure structure;
  structure.rods = {models::slender_rod(true, 24, 1.0, 300),
                    models::slender_rod(true, 20, 1.2, 300)};
  for (int k = 0; k < 5; ++k)
    structure.cables.push_back({.a = springs::OnRod{0, 0.21 * k},
                                .b = springs::OnRod{1, 0.05 + 0.23 * k},
                                .stiffness = 40.0 + k,
                                .rest_length = 0.01 * k});
  structure.cables.push_back(
      {.a = springs::OnRod{0, 0.33}, .b = springs::OnRod{0, 0.9}, .stiffness = 30.0});
  return structure;
}

model::State linked_state(const model::Structure& structure) {
  Eigen::Matrix3Xd second = models::polygon(20, 1.2);
  second.row(2) = second.row(1);
  second.row(1).setZero();
  second.row(0).array() += 0.15;
  return model::make_state(structure, {models::polygon(24, 1.0), second});
}

}  // namespace

TEST_CASE("the system's gradient and Hessian match differences of its energy") {
  std::srand(3);
  model::Structure structure = linked_rings();
  structure.pins = {{.rod = 0, .vertex = 3, .axes = {true, false, true}}};
  structure.anchors = Eigen::Vector3d(0.5, 0.2, 0.4);
  structure.cables.push_back(
      {.a = springs::AtAnchor{0}, .b = springs::OnRod{1, 0.4}, .stiffness = 9});
  const System system(structure);
  model::State state = linked_state(structure);
  system.displace(state, 0.003 * Eigen::VectorXd::Random(system.size()));
  REQUIRE(system.size() == 3 * 44 - 2);
  const Eigen::VectorXd direction = Eigen::VectorXd::Random(system.size());
  const double step = 1e-6;
  const model::State plus = system.displaced(state, step * direction);
  const model::State minus = system.displaced(state, -step * direction);
  CHECK(system.gradient(state).dot(direction) ==
        Approx((system.energy(plus) - system.energy(minus)) / (2 * step)).epsilon(1e-6));
  const Eigen::VectorXd change = (system.gradient(plus) - system.gradient(minus)) / (2 * step);
  CHECK((dense_hessian(system, state) * direction - change).norm() < 1e-7 * change.norm());
}

TEST_CASE("anchoring keeps inertia and solves exact at an equilibrium") {
  const model::Structure structure = linked_rings();
  const System system(structure);
  Linearisation at;
  const Equilibrium result = solve(system, linked_state(structure), {}, at);
  REQUIRE(result.usable());
  const Eigen::MatrixXd h = dense_hessian(system, result.state);
  const Eigen::VectorXd spectrum = tencer::test::eigenvalues(h);
  // Six zero modes, the rest positive.
  CHECK(std::abs(spectrum[5]) < 1e-6 * spectrum[6]);
  CHECK(spectrum[6] > 0);
  CHECK(at.negative == 0);

  Eigen::VectorXd load = Eigen::VectorXd::Random(system.size());
  remove_rigid(at.rigid, load);
  const Eigen::VectorXd answer = at.solve(load);
  CHECK((h * answer - load).norm() < 1e-7 * load.norm());
  for (const auto& mode : at.rigid)
    CHECK((mode.basis.transpose() * answer).norm() < 1e-9 * answer.norm());
}

TEST_CASE("an equilibrium does not depend on where the structure starts in space") {
  const model::Structure structure = linked_rings();
  const System system(structure);
  const model::State state = linked_state(structure);
  const Eigen::Matrix3d turn =
      Eigen::AngleAxisd(1.1, Eigen::Vector3d(1, 2, 3).normalized()).toRotationMatrix();
  model::State moved = state;
  for (auto& rod : moved) rod.x = (turn * rod.x).colwise() + Eigen::Vector3d(0.3, -0.2, 0.5);
  const Equilibrium a = solve(system, state);
  const Equilibrium b = solve(system, moved);
  REQUIRE(a.usable());
  REQUIRE(b.usable());
  CHECK(a.energy == Approx(b.energy).epsilon(1e-11));
  const double span_a = (a.state[0].x.col(0) - a.state[1].x.col(7)).norm();
  const double span_b = (b.state[0].x.col(0) - b.state[1].x.col(7)).norm();
  CHECK(span_a == Approx(span_b).epsilon(1e-8));
}

TEST_CASE("the smallest eigenvalue matches the dense spectrum") {
  const model::Structure structure = linked_rings();
  const System system(structure);
  const Equilibrium result = solve(system, linked_state(structure));
  const Stability found = stability(system, result.state);
  Eigen::VectorXd mass = Eigen::VectorXd::Constant(system.size(), 1.0 / 24);
  mass.tail(60).setConstant(1.2 / 20);
  const Eigen::VectorXd root = mass.cwiseSqrt().cwiseInverse();
  const Eigen::MatrixXd scaled =
      root.asDiagonal() * dense_hessian(system, result.state) * root.asDiagonal();
  const Eigen::VectorXd values = tencer::test::eigenvalues(scaled);
  CHECK(found.stable());
  CHECK(found.smallest_eigenvalue == Approx(values[6] * std::pow(2.2, 4)).epsilon(1e-6));
}

TEST_CASE("rods that nothing ties together are not called stable") {
  model::Structure structure = linked_rings();
  structure.cables.clear();
  const System system(structure);
  const Equilibrium result = solve(system, linked_state(structure));
  CHECK(result.usable());
  const Stability found = stability(system, result.state);
  CHECK(found.floating_components == 2);
  CHECK_FALSE(found.stable());
}

TEST_CASE("a solve that cannot go on says why and keeps its best state") {
  const model::Structure structure = linked_rings();
  const System system(structure);
  const Equilibrium limited = solve(system, linked_state(structure), {.max_iterations = 1});
  CHECK(limited.reason == Reason::iteration_limit);
  const Equilibrium too_far = solve(system, linked_state(structure), {.max_path_rotation = 0.01});
  CHECK(too_far.reason == Reason::path_limit);
  CHECK(too_far.iterations < 2);
  CHECK_FALSE(limited.usable());
  CHECK(limited.state.size() == 2);

  std::stop_source source;
  source.request_stop();
  CHECK(solve(system, linked_state(structure), {.stop = source.get_token()}).reason ==
        Reason::stopped);

  model::Structure folded;
  folded.rods = {models::slender_rod(false, 3, 1.0)};
  Eigen::Matrix3Xd x(3, 3);
  x << 0, 0.5, 0, 0, 0, 0, 0, 0, 0;
  CHECK(solve(System(folded), model::make_state(folded, {x})).reason == Reason::not_finite);
}

TEST_CASE("structures that make no sense are refused by name") {
  model::Structure structure = linked_rings();
  structure.cables[0].b = springs::OnRod{2, 0.0};
  CHECK_THROWS_WITH(System(structure), Catch::Contains("no such rod"));
  structure = linked_rings();
  structure.pins = {{.rod = 0, .vertex = 24}};
  CHECK_THROWS_WITH(System(structure), Catch::Contains("pin"));
  structure = linked_rings();
  structure.rods[1].section.EA = 0;
  CHECK_THROWS_WITH(System(structure), Catch::Contains("EA"));
}

TEST_CASE("replacing cables gives the same system as building it anew") {
  const model::Structure structure = linked_rings();
  System changed(structure);
  auto cables = structure.cables;
  cables[1].a = springs::OnRod{0, 0.77};
  cables.pop_back();
  changed.set_cables(cables);
  model::Structure fresh_structure = structure;
  fresh_structure.cables = cables;
  const System fresh(fresh_structure);
  const model::State state = linked_state(structure);
  CHECK(changed.gradient(state) == fresh.gradient(state));
  CHECK(dense_hessian(changed, state) == dense_hessian(fresh, state));
}

TEST_CASE("a workspace serves cables that moved to other edges") {
  model::Structure structure = linked_rings();
  System system(structure);
  Linearisation workspace;
  const Equilibrium first = solve(system, linked_state(structure), {}, workspace);
  REQUIRE(first.usable());
  // As many couplings as before, between other vertices.
  auto cables = structure.cables;
  for (auto& cable : cables) std::get<springs::OnRod>(cable.a).s += 0.3;
  system.set_cables(cables);
  REQUIRE(system.pattern().nonZeros() == workspace.matrix.nonZeros());
  const Equilibrium reused = solve(system, first.state, {}, workspace);
  const Equilibrium fresh = solve(system, first.state);
  CHECK(reused.iterations == fresh.iterations);
  CHECK(reused.energy == fresh.energy);
}

TEST_CASE("stretching does not slow a solve down, however slender the rod") {
  // Six soft springs crumple a ring: far from the start, and along a narrow curved valley.
  std::vector<int> iterations;
  for (double EA : {1e3, 1e6, 1e9}) {
    model::Structure ring;
    const double length = 2 * std::numbers::pi;
    ring.rods = {models::slender_rod(true, 24, length)};
    ring.rods[0].section.EA = EA;
    for (int k = 0; k < 6; ++k)
      ring.cables.push_back({.a = springs::OnRod{0, 0.151 * k * length},
                             .b = springs::OnRod{0, (0.4 + 0.13 * k) * length},
                             .stiffness = 2 + 0.5 * k});
    const System system(ring);
    model::State start = model::make_state(ring, {models::polygon(24, length)});
    for (int i = 0; i < 24; ++i) start[0].x(2, i) += 0.05 * std::sin(2.0 * i * i);
    const Equilibrium result = solve(system, start);
    REQUIRE(result.usable());
    iterations.push_back(result.iterations);
  }
  CHECK(iterations[2] <= 2 * iterations[0]);
}

TEST_CASE("predicted forces spare a solve that starts from a predicted shape iterations") {
  model::Structure ring;
  const double length = 2 * std::numbers::pi;
  ring.rods = {models::slender_rod(true, 48, length)};
  ring.cables.push_back({.a = springs::OnRod{0, 0.1},
                         .b = springs::OnRod{0, 0.1 + length / 2},
                         .stiffness = 5,
                         .rest_length = 1.5});
  const Equilibrium first = solve(
      System(ring), model::make_state(ring, {models::polygon(48, length)}), {.tolerance = 1e-9});
  REQUIRE(first.usable());
  // To first order, what a stronger cable does.
  Linearisation at;
  linearise(System(ring), first.state, at);
  ring.cables[0].stiffness = 5.5;
  const System stronger(ring);
  const Eigen::VectorXd step = at.solve(-stronger.gradient(first.state));
  const model::State start = stronger.displaced(first.state, step);
  const Equilibrium without = solve(stronger, start, {.tolerance = 1e-9});
  const Equilibrium with =
      solve(stronger, start,
            {.tolerance = 1e-9, .forces = predicted_forces(stronger, first.state, step)});
  REQUIRE(without.usable());
  REQUIRE(with.usable());
  CHECK(with.iterations < without.iterations);
  CHECK(with.energy == Approx(without.energy).epsilon(1e-12));
  CHECK_THROWS_AS(solve(stronger, start, {.forces = InternalForces{}}), std::invalid_argument);
  InternalForces short_of_an_edge = predicted_forces(stronger, first.state, step);
  short_of_an_edge.axial[0].conservativeResize(47);
  CHECK_THROWS_AS(solve(stronger, start, {.forces = short_of_an_edge}), std::invalid_argument);
}

TEST_CASE("an equilibrium that some motion leaves at no cost is not called stable") {
  // Two rods that a single point ties together turn about it freely.
  model::Structure structure;
  structure.rods = {models::slender_rod(false, 5, 1.0, 100),
                    models::slender_rod(false, 5, 1.0, 100)};
  structure.cables = {{.a = springs::OnRod{0, 0.5}, .b = springs::OnRod{1, 0.5}, .stiffness = 3}};
  Eigen::Matrix3Xd second = models::straight(5, 1.0);
  second.row(1) = second.row(0).array() - 0.5;
  second.row(0).setConstant(0.5);
  const System system(structure);
  const Equilibrium result =
      solve(system, model::make_state(structure, {models::straight(5, 1.0), second}));
  CHECK_FALSE(stability(system, result.state).stable());
  CHECK_FALSE(result.usable());
  CHECK(result.reason == Reason::neutral);
}

// What turns a rod about the line between its ends moves it less and less as it straightens, until
// it is no motion at all.
TEST_CASE("a bent rod that nothing holds straightens, free or clamped at one end") {
  const int vertices = 21;
  model::Structure rod{.rods = {models::slender_rod(false, vertices, 1.0)}};
  if (GENERATE(false, true)) rod.pins = {{.rod = 0, .vertex = 0}, {.rod = 0, .vertex = 1}};
  Eigen::Matrix3Xd bent = models::straight(vertices, 1.0);
  for (int i = 2; i < vertices; ++i) {
    const double s = bent(0, i) - bent(0, 1);
    bent(1, i) = 0.1 * s * s;
    bent(2, i) = 0.05 * s * s * s;
  }
  const Equilibrium found = solve(System(rod), model::make_state(rod, {bent}));
  CHECK(found.usable());
  CHECK(found.factorisations < 20);
  CHECK(found.energy < 1e-12);
}
