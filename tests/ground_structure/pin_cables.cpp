// Pins replaced by cables: they pull as the pins did, and the rods stay where they are.
#include <catch2/catch.hpp>
#include <numbers>
#include <random>
#include <tencer/equilibrium/stability.hpp>
#include <tencer/ground_structure/pin_cables.hpp>
#include <tencer/symmetry/detect.hpp>
#include <tencer/symmetry/orbit.hpp>

#include "equilibrium/models.hpp"
#include "fixtures/cube.hpp"
#include "fixtures/elastica.hpp"
#include "fixtures/second_order.hpp"

using namespace tencer;
using fixtures::elastica;
using ground_structure::anchor_pull;
using ground_structure::pin_forces;
using ground_structure::replace_pins;

namespace {

Eigen::Vector3d pull(const Eigen::Vector3d& point, const ground_structure::AnchorPull& hold,
                     const Eigen::Matrix3Xd& anchors) {
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (std::size_t i = 0; i < hold.anchors.size(); ++i)
    sum += hold.tensions[static_cast<Eigen::Index>(i)] *
           (anchors.col(hold.anchors[i]) - point).normalized();
  return sum;
}

// The elastica at rest between two pins, in the plane within four anchors.
network::Network pinned_arc(int vertices, double angle) {
  network::Network network;
  auto& structure = network.structure;
  structure.rods = {models::slender_rod(false, vertices, 1.0)};
  structure.pins = {{.rod = 0, .vertex = 0}, {.rod = 0, .vertex = vertices - 1}};
  structure.planar = true;
  structure.anchors.resize(3, 4);
  structure.anchors << -1, 2, 2, -1, -1, -1, 1, 1, 0, 0, 0, 0;
  auto solved = equilibrium::solve(equilibrium::System(structure),
                                   model::make_state(structure, {elastica(vertices, angle).x}));
  REQUIRE(solved.usable());
  network.state = std::move(solved.state);
  return network;
}

// What the network, pinned where it is to stay, is sought for.
ground_structure::Problem problem_of(const network::Network& pinned) {
  ground_structure::Problem problem{.structure = pinned.structure, .start = pinned.state};
  problem.structure.cables.clear();
  std::vector<Eigen::Matrix3Xd> points;
  for (const auto& rod : pinned.state) points.push_back(rod.x);
  problem.target = model::make_target(pinned.structure, std::move(points));
  return problem;
}

}  // namespace

TEST_CASE("three anchors take a force over, whatever its direction") {
  const Eigen::Matrix3Xd anchors = cube(10);
  std::mt19937 generator(7);
  std::uniform_real_distribution<double> number(-1, 1);
  const auto random = [&] {
    const double x = number(generator), y = number(generator), z = number(generator);
    return Eigen::Vector3d(x, y, z);
  };
  for (int trial = 0; trial < 200; ++trial) {
    const Eigen::Vector3d point = 9 * random();
    const Eigen::Vector3d force = random();
    const auto hold = anchor_pull(point, force, anchors);
    REQUIRE(hold.anchors.size() == 3);
    CHECK(hold.tensions.minCoeff() > 0);
    CHECK((pull(point, hold, anchors) - force).norm() < 1e-12 * hold.tensions.sum());
  }
}

TEST_CASE("anchors that hold a point most firmly are chosen") {
  // Three at right angles about the force, three next to it, and one behind.
  Eigen::Matrix3Xd anchors(3, 7);
  anchors.leftCols(3) = 10 * Eigen::Matrix3d::Identity();
  anchors.middleCols(3, 3) = anchors.leftCols(3).array() + 30;
  anchors.col(6).setConstant(-10);
  const Eigen::Vector3d force = Eigen::Vector3d::Ones();
  const auto chosen = anchor_pull(Eigen::Vector3d::Zero(), force, anchors);
  CHECK(chosen.anchors == std::vector<int>{0, 1, 2});
  CHECK((chosen.tensions.array() - 1).abs().maxCoeff() < 1e-12);
  // A change of the force in any direction by less than this leaves all of them taut.
  for (int axis = 0; axis < 3; ++axis)
    CHECK(anchor_pull(Eigen::Vector3d::Zero(), force - 0.99 * Eigen::Vector3d::Unit(axis),
                      anchors.leftCols(3))
              .anchors.size() == 3);
}

TEST_CASE("fewer cables hold a vertex where the force points at an anchor") {
  const Eigen::Matrix3Xd anchors = cube(10).leftCols(7);
  Eigen::Matrix3Xd tetrahedron(3, 4);
  tetrahedron << 1, 1, -1, -1, 1, -1, 1, -1, 1, -1, -1, 1;
  const auto one = anchor_pull(Eigen::Vector3d::Zero(), Eigen::Vector3d(3, 3, 3), tetrahedron);
  CHECK(one.anchors == std::vector<int>{0});
  CHECK(one.tensions[0] == Approx(std::sqrt(27.0)));
  CHECK(anchor_pull(Eigen::Vector3d::Zero(), Eigen::Vector3d::Zero(), anchors).anchors.empty());
}

TEST_CASE("anchors out of reach take nothing over") {
  Eigen::Matrix3Xd anchors(3, 16);
  anchors << cube(10), cube(40);
  const Eigen::Vector3d force(0.3, 0.5, 1);
  for (const int anchor : anchor_pull(Eigen::Vector3d(1, 2, 0), force, anchors, false, 25).anchors)
    CHECK(anchor < 8);
  CHECK_THROWS_AS(anchor_pull(Eigen::Vector3d(60, 0, 0), Eigen::Vector3d::UnitX(), anchors),
                  std::invalid_argument);
}

TEST_CASE("hinged ends hold an elastica with the force of its closed form, to second order") {
  const double angle = 1.0;
  const auto error = [&](int edges) {
    const auto network = pinned_arc(edges + 1, angle);
    const Eigen::Matrix3Xd forces = pin_forces(network.structure, network.state);
    CHECK((forces.col(0) + forces.col(1)).norm() < 1e-6 * forces.norm());
    CHECK(std::abs(forces(1, 0)) < 1e-6 * forces.norm());
    return forces(0, 0) / elastica(2, angle).load - 1;
  };
  check_second_order(error, 20, 5e-3);
}

TEST_CASE("an elastica is handed over from its hinges to cables that pull as they did") {
  const auto pinned = pinned_arc(41, 1.0);
  const Eigen::Matrix3Xd forces = pin_forces(pinned.structure, pinned.state);
  const auto result = replace_pins(pinned, problem_of(pinned));
  CHECK(result.valid());
  CHECK(result.network.structure.pins.empty());
  REQUIRE(result.network.structure.cables.size() == 4);
  CHECK((result.network.state[0].x - pinned.state[0].x).norm() < 1e-8);
  CHECK(equilibrium::stability(equilibrium::System(result.network.structure), result.network.state)
            .stable());
  REQUIRE(result.trace.size() == 1);
  CHECK(result.trace[0].cables == 4);
  CHECK(result.trace[0].max_percent < 1e-6);

  const Eigen::VectorXd tensions = network::cable_tensions(result.network);
  Eigen::Vector3d at_start = Eigen::Vector3d::Zero();
  Eigen::Vector3d at_end = Eigen::Vector3d::Zero();
  for (std::size_t c = 0; c < 4; ++c) {
    const auto& cable = result.network.structure.cables[c];
    const auto& place = std::get<springs::OnRod>(cable.a);
    const bool start = place.s == 0;
    const Eigen::Vector3d point = result.network.state[0].x.col(start ? 0 : 40);
    const Eigen::Vector3d anchor =
        result.network.structure.anchors.col(std::get<springs::AtAnchor>(cable.b).anchor);
    (start ? at_start : at_end) +=
        tensions[static_cast<Eigen::Index>(c)] * (anchor - point).normalized();
  }
  CHECK((at_start - forces.col(0)).norm() < 1e-6 * forces.norm());
  CHECK((at_end - forces.col(1)).norm() < 1e-6 * forces.norm());
}

TEST_CASE("pins that a symmetry maps onto each other get the same cables") {
  // Two mirror images, each bent by its pins, and a cable between them.
  const int n = 21;
  const Eigen::Matrix3Xd arc = elastica(n, 0.8).x;
  network::Network network;
  auto& structure = network.structure;
  for (int r = 0; r < 2; ++r) {
    structure.rods.push_back(models::slender_rod(false, n, 1.0));
    for (const int vertex : {0, n - 1}) structure.pins.push_back({.rod = r, .vertex = vertex});
  }
  Eigen::Matrix3Xd one = arc.colwise() - Eigen::Vector3d(0.45, 0.5, 0);
  one.row(2).setConstant(-0.1);
  Eigen::Matrix3Xd other = one;
  other.row(1) *= -1;
  structure.anchors = cube(2);
  structure.cables = {{.a = springs::OnRod{0, 0.5}, .b = springs::OnRod{1, 0.5}, .stiffness = 3}};
  auto solved = equilibrium::solve(equilibrium::System(structure),
                                   model::make_state(structure, {one, other}));
  REQUIRE(solved.usable());
  network.state = std::move(solved.state);

  symmetry::Figure figure{.anchors = structure.anchors};
  for (int r = 0; r < 2; ++r) {
    figure.curves.push_back({.points = network.state[r].x, .closed = false});
    figure.rods.emplace_back(structure.rods[r].rest_lengths, false);
  }
  const auto found = symmetry::detect(figure);
  REQUIRE(found.group.order() >= 2);
  ground_structure::Problem problem = problem_of(network);
  problem.symmetry = found.group;
  const auto result = replace_pins(network, problem);
  CHECK(result.valid());
  const auto& cables = result.network.structure.cables;
  CHECK(cables.size() > 4);
  CHECK(symmetry::complete(cables, found.group).size() == cables.size());
  CHECK((result.network.state[0].x - network.state[0].x).norm() < 1e-6);
}
