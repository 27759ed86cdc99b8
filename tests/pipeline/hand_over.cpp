// Pins handed over to cables: they pull as the pins did, and the rods stay where they are.
#include <numbers>
#include <random>
#include <tencer/equilibrium/solve.hpp>
#include <tencer/equilibrium/stability.hpp>
#include <tencer/pipeline/hand_over.hpp>
#include <tencer/symmetry/detect.hpp>
#include <tencer/symmetry/orbit.hpp>

#include "../cube.hpp"
#include "../equilibrium/models.hpp"
#include "../equilibrium/second_order.hpp"
#include "scenes.hpp"

using namespace tencer;

namespace {

Eigen::Vector3d pull(const Eigen::Vector3d& point, const pipeline::Hold& hold,
                     const Eigen::Matrix3Xd& anchors) {
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (std::size_t i = 0; i < hold.anchors.size(); ++i)
    sum += hold.tensions[static_cast<Eigen::Index>(i)] *
           (anchors.col(hold.anchors[i]) - point).normalized();
  return sum;
}

// The planar elastica of length 1 whose ends are hinged and make `angle` with the line between
// them, from (0, 0, 0) along x, by Runge-Kutta steps of theta'' = -load sin theta (EI = 1).
struct Elastica {
  Eigen::Matrix3Xd x;
  double load = 0.0;
};

Elastica elastica(int vertices, double angle) {
  const double K = std::comp_ellint_1(std::sin(angle / 2));
  Elastica result{.x = Eigen::Matrix3Xd::Zero(3, vertices), .load = 4 * K * K};
  constexpr int steps = 100;
  const double h = 1.0 / (steps * (vertices - 1));
  using State = Eigen::Vector4d;  // theta, theta', x, y
  const auto rate = [&](const State& at) {
    return State(at[1], -result.load * std::sin(at[0]), std::cos(at[0]), std::sin(at[0]));
  };
  State at(angle, 0, 0, 0);
  for (int i = 1; i < vertices; ++i) {
    for (int k = 0; k < steps; ++k) {
      const State a = rate(at), b = rate(at + h / 2 * a), c = rate(at + h / 2 * b),
                  d = rate(at + h * c);
      at += h / 6 * (a + 2 * b + 2 * c + d);
    }
    result.x.col(i) << at[2], at[3], 0;
  }
  return result;
}

// The elastica at rest between two pins, in the plane within four anchors.
sparsify::Network pinned_arc(int vertices, double angle) {
  sparsify::Network network;
  auto& structure = network.structure;
  structure.rods = {models::slender_rod(false, vertices, 1.0)};
  structure.pins = {{.rod = 0, .vertex = 0}, {.rod = 0, .vertex = vertices - 1}};
  structure.planar = true;
  structure.anchors.resize(3, 4);
  structure.anchors << -1, 2, 2, -1, -1, -1, 1, 1, 0, 0, 0, 0;
  auto solved = equilibrium::solve(equilibrium::System(structure),
                                   make_state(structure, {elastica(vertices, angle).x}));
  REQUIRE(solved.usable());
  network.state = std::move(solved.state);
  return network;
}

// 100 long, to be handed over from its hinges to four anchors.
io::Scene arc_scene(double angle) {
  io::Scene scene = scene_of({{.points = 100 * elastica(40, angle).x, .closed = false}});
  scene.planar = true;
  scene.pinned = {{.rod = 0, .vertex = 0}, {.rod = 0, .vertex = 39}};
  scene.anchors.resize(3, 4);
  scene.anchors << -20, 110, 110, -20, -20, -20, 60, 60, 0, 0, 0, 0;
  scene.design.external = false;
  scene.design.hand_over = true;
  return scene;
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
    const auto hold = pipeline::hold(point, force, anchors);
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
  const auto chosen = pipeline::hold(Eigen::Vector3d::Zero(), force, anchors);
  CHECK(chosen.anchors == std::vector<int>{0, 1, 2});
  CHECK((chosen.tensions.array() - 1).abs().maxCoeff() < 1e-12);
  // A change of the force in any direction by less than this leaves all of them taut.
  for (int axis = 0; axis < 3; ++axis)
    CHECK(pipeline::hold(Eigen::Vector3d::Zero(), force - 0.99 * Eigen::Vector3d::Unit(axis),
                         anchors.leftCols(3))
              .anchors.size() == 3);
}

TEST_CASE("fewer cables hold a vertex where the force points at an anchor") {
  const Eigen::Matrix3Xd anchors = cube(10).leftCols(7);
  Eigen::Matrix3Xd tetrahedron(3, 4);
  tetrahedron << 1, 1, -1, -1, 1, -1, 1, -1, 1, -1, -1, 1;
  const auto one = pipeline::hold(Eigen::Vector3d::Zero(), Eigen::Vector3d(3, 3, 3), tetrahedron);
  CHECK(one.anchors == std::vector<int>{0});
  CHECK(one.tensions[0] == Approx(std::sqrt(27.0)));
  CHECK(pipeline::hold(Eigen::Vector3d::Zero(), Eigen::Vector3d::Zero(), anchors).anchors.empty());
}

TEST_CASE("anchors out of reach take nothing over") {
  Eigen::Matrix3Xd anchors(3, 16);
  anchors << cube(10), cube(40);
  const Eigen::Vector3d force(0.3, 0.5, 1);
  for (const int anchor :
       pipeline::hold(Eigen::Vector3d(1, 2, 0), force, anchors, false, 25).anchors)
    CHECK(anchor < 8);
  CHECK_THROWS_AS(pipeline::hold(Eigen::Vector3d(60, 0, 0), Eigen::Vector3d::UnitX(), anchors),
                  std::invalid_argument);
}

TEST_CASE("hinged ends hold an elastica with the force of its closed form, to second order") {
  const double angle = 1.0;
  const auto error = [&](int edges) {
    const auto network = pinned_arc(edges + 1, angle);
    const Eigen::Matrix3Xd forces = pipeline::reactions(network.structure, network.state);
    CHECK((forces.col(0) + forces.col(1)).norm() < 1e-6 * forces.norm());
    CHECK(std::abs(forces(1, 0)) < 1e-6 * forces.norm());
    return forces(0, 0) / elastica(2, angle).load - 1;
  };
  check_second_order(error, 20, 5e-3);
}

TEST_CASE("an elastica is handed over from its hinges to cables that pull as they did") {
  const auto pinned = pinned_arc(41, 1.0);
  const Eigen::Matrix3Xd forces = pipeline::reactions(pinned.structure, pinned.state);
  sensitivity::Target target = sensitivity::make_target(pinned.structure, {pinned.state[0].x});
  const auto result = pipeline::hand_over(pinned, target);
  CHECK(result.sound);
  CHECK(result.network.structure.pins.empty());
  REQUIRE(result.network.structure.cables.size() == 4);
  CHECK((result.network.state[0].x - pinned.state[0].x).norm() < 1e-8);
  CHECK(equilibrium::stability(equilibrium::System(result.network.structure), result.network.state)
            .stable());
  REQUIRE(result.trace.size() == 1);
  CHECK(result.trace[0].cables == 4);
  CHECK(result.trace[0].max_percent < 1e-6);

  const Eigen::VectorXd tensions = sparsify::cable_tensions(result.network);
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
  sparsify::Network network;
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
  auto solved =
      equilibrium::solve(equilibrium::System(structure), make_state(structure, {one, other}));
  REQUIRE(solved.usable());
  network.state = std::move(solved.state);

  symmetry::Figure figure{.anchors = structure.anchors};
  for (int r = 0; r < 2; ++r) {
    figure.curves.push_back({.points = network.state[r].x, .closed = false});
    figure.rods.emplace_back(structure.rods[r].rest_lengths, false);
  }
  const auto found = symmetry::detect(figure);
  REQUIRE(found.group.order() >= 2);
  const auto target = sensitivity::make_target(structure, {network.state[0].x, network.state[1].x});
  const auto result = pipeline::hand_over(network, target, &found.group);
  CHECK(result.sound);
  const auto& cables = result.network.structure.cables;
  CHECK(cables.size() > 4);
  CHECK(symmetry::complete(cables, found.group).size() == cables.size());
  CHECK((result.network.state[0].x - network.state[0].x).norm() < 1e-6);
}

TEST_CASE("a design whose pins are handed over stands without them") {
  const double angle = 1.0;
  const io::Scene scene = arc_scene(angle);
  const io::Design design = designed(scene);
  CHECK(design.status == io::DesignStatus::complete);
  CHECK(design.pinned.empty());
  CHECK(design.error->max_percent <= 1);
  CHECK(
      std::ranges::any_of(design.trace, [](const auto& row) { return row.stage == "hand-over"; }));
  REQUIRE_FALSE(design.cables.empty());
  Eigen::Vector3d on_left = Eigen::Vector3d::Zero();
  for (const auto& cable : design.cables) {
    CHECK(is_external(cable));
    if (end_point(design, cable.a).x() > 40) continue;
    on_left +=
        cable.tension * (end_point(design, cable.b) - end_point(design, cable.a)).normalized();
  }
  const double load = elastica(2, angle).load * scene.rods[0].section.EI[0] / 1e4;
  CHECK(on_left.x() == Approx(load).epsilon(0.05));
  CHECK(std::abs(on_left.y()) < 0.05 * load);
}

TEST_CASE("a number of cables counts those in place of pins, and all numbers are without pins") {
  io::Scene scene = arc_scene(1.0);
  SECTION("a number") {
    scene.design.cables = 4;
    const io::Design design = designed(scene);
    CHECK(design.status == io::DesignStatus::complete);
    CHECK(design.cables.size() <= 4);
    CHECK(design.pinned.empty());
  }
  SECTION("all numbers") {
    const auto designs = pipeline::trade_off(scene);
    REQUIRE(designs);
    for (const io::Design& design : *designs) {
      CHECK(design.pinned.empty());
      CHECK(std::ranges::any_of(design.cables, is_external));
    }
  }
}

TEST_CASE("an end that a pin does not pull at is just let go") {
  // A straight rod: nothing to take over, and no cables.
  Eigen::Matrix3Xd line = Eigen::Matrix3Xd::Zero(3, 10);
  for (int i = 0; i < 10; ++i) line(0, i) = i;
  io::Scene scene = scene_of({{.points = line, .closed = false}});
  scene.pinned = {{.rod = 0, .vertex = 0}, {.rod = 0, .vertex = 9}};
  scene.anchors = cube(20);
  scene.design.external = false;
  scene.design.hand_over = true;
  const io::Design design = designed(scene);
  CHECK(design.cables.empty());
  CHECK(design.pinned.empty());
  CHECK(design.status == io::DesignStatus::complete);
}

TEST_CASE("anchors have to surround the pins that they take over") {
  io::Scene scene = scene_of({{.points = 100 * elastica(20, 1.0).x, .closed = false}});
  scene.pinned = {{.rod = 0, .vertex = 0}, {.rod = 0, .vertex = 19}};
  scene.anchors = cube(50).colwise() + Eigen::Vector3d(40, 20, 0);
  scene.design.hand_over = true;
  CHECK(error_of(scene) == "no error");
  SECTION("beside them") {
    scene.anchors.row(0).array() += 20;
    CHECK_THAT(error_of(scene),
               Catch::Matchers::StartsWith("small.obj: design.hand_over: the anchors must surround "
                                           "every pinned vertex, but vertex 0 of rod 0 is not"));
  }
  SECTION("out of reach") {
    scene.design.longest_cable = 60;
    CHECK_THAT(error_of(scene), Catch::Matchers::Contains("that the longest cable reaches"));
  }
}
