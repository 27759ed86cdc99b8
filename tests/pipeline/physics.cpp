// Scenes with known answers: what a scene file says of sections, rest shapes, twist and loads is
// what the rods do.
#include <numbers>
#include <sstream>
#include <tencer/curves/families.hpp>
#include <tencer/equilibrium/solve.hpp>
#include <tencer/equilibrium/stability.hpp>
#include <tencer/model/frames.hpp>
#include <tencer/pipeline/prepare.hpp>
#include <tencer/pipeline/simulate.hpp>

#include "fixtures/folder.hpp"
#include "fixtures/second_order.hpp"
#include "scenes.hpp"

using namespace tencer;
using std::numbers::pi;

namespace {

std::string text(double number) {
  std::ostringstream stream;
  stream.precision(17);
  stream << number;
  return stream.str();
}

model::Scene scene_of_text(const Folder& folder, const std::string& toml) {
  return scene_at(folder.put("scene.toml", toml));
}

ground_structure::Problem problem_of(const Folder& folder, const std::string& toml) {
  return prepared_of(scene_of_text(folder, toml)).problem;
}

// The scene's rods without cables, at the target, with the frames in which they start.
model::Design bare(const model::Scene& scene) {
  model::Design design{
      .structure = scene.structure, .target = scene.target.points, .pose = scene.target.points};
  for (const auto& rod : prepared_of(scene).problem.start)
    design.target_directors.push_back(model::directors(rod));
  design.pose_directors = design.target_directors;
  return design;
}

model::Design bare(const Folder& folder, const std::string& toml) {
  return bare(scene_of_text(folder, toml));
}

// A straight rod along x.
std::string line(int edges, double from, double to) {
  std::string points;
  for (int i = 0; i <= edges; ++i) points += text(from + (to - from) * i / edges) + ",0,0\n";
  return points;
}

// Where the rods come to rest without cables, from the target.
pipeline::Simulation released(const model::Design& file) {
  const auto simulation = pipeline::simulate(file, {.start = pipeline::Start::target});
  REQUIRE(simulation);
  REQUIRE(simulation->usable());
  return *simulation;
}

// How far the tip of a horizontal tube sinks, 100 cm from a clamp in the middle of its first edge.
double tip(int edges, const std::string& load) {
  const Folder folder;
  const double edge = 100 / (edges - 0.5);
  folder.put("line.csv", line(edges, -edge / 2, 100));
  const auto design =
      bare(folder, load + "pinned = [{rod = 0, vertex = 0}, {rod = 0, vertex = 1}]\n[[rod]]\n" +
                       "curve = 'line.csv'\nsection = {shape = 'tube', outer_radius = 0.5, " +
                       "inner_radius = 0.4, youngs_modulus = 4e6, density = 1900}\n");
  const auto simulation = released(design);
  CHECK(simulation.design.certificate->stable);
  const auto& pose = simulation.design.pose[0];
  return -pose(2, pose.cols() - 1);
}

const double tube_EI = 4e6 * pi / 4 * (std::pow(0.5, 4) - std::pow(0.4, 4));

}  // namespace

TEST_CASE("a tube sinks under its weight by w L^4 / 8 EI") {
  // N/cm: density in kg/cm^3 times area times 0.1 m/s^2.
  const double weight = 1900e-6 * pi * (0.25 - 0.16) * 0.1;
  check_second_order(
      [&](int edges) {
        return tip(edges, "gravity = [0, 0, -0.1]\n") / (weight * 1e8 / (8 * tube_EI)) - 1;
      },
      20, 2e-3);
}

TEST_CASE("a tube sinks under a load at its tip by P L^3 / 3 EI") {
  check_second_order(
      [&](int edges) {
        const std::string s = text(100 * edges / (edges - 0.5) * (1 - 1e-14));
        return tip(edges, "loads = [{rod = 0, s = " + s + ", force = [0, 0, -1e-3]}]\n") /
                   (1e-3 * 1e6 / (3 * tube_EI)) -
               1;
      },
      20, 2e-3);
}

TEST_CASE("a strip between pinned ends buckles about its soft axis at Euler's load") {
  // Its first axis, along which it is thin, points along y.
  const auto critical = [](int edges) {
    const Folder folder;
    folder.put("line.csv", line(edges, 0, 100));
    const auto problem = problem_of(
        folder, "pinned = [{rod = 0, vertex = 0}, {rod = 0, vertex = " + std::to_string(edges) +
                    "}]\n[[rod]]\ncurve = 'line.csv'\ndirector = [0, 1, 0]\nsection = {shape = "
                    "'rectangle', width = 0.2, height = 1, youngs_modulus = 4e6}\n");
    const auto& section = problem.structure.rods[0].section;
    REQUIRE(section.EI1 == Approx(25 * section.EI2));
    const equilibrium::System system(problem.structure);
    const double euler = pi * pi * section.EI2;  // the scaled length is 1
    double stable = 0.5 * euler;
    double unstable = 2 * euler;
    while (unstable - stable > 1e-9 * euler) {
      const double load = (stable + unstable) / 2;
      const Eigen::Matrix3Xd& x = problem.start[0].x;
      auto state = model::make_state(problem.structure, {x * (1 - load / section.EA)});
      der::set_material_frame(state[0], 0, Eigen::Vector3d::UnitY());
      state[0].theta.setConstant(state[0].theta[0]);
      const auto stability = equilibrium::stability(system, state);
      REQUIRE(stability.computed);
      (stability.negative == 0 ? stable : unstable) = load;
      if (stability.negative > 0) {
        double along_y = 0;
        double along_z = 0;
        for (int v = 1; v + 1 < x.cols(); ++v) {
          along_y += std::abs(stability.mode[system.position_index(0, v, 1)]);
          along_z += std::abs(stability.mode[system.position_index(0, v, 2)]);
        }
        CHECK(along_z < 1e-3 * along_y);
      }
    }
    return stable / euler - 1;
  };
  check_second_order(critical, 20, 1e-3);
}

TEST_CASE("a strip that rests in its target is free of force, and comes back to it") {
  const Folder folder;
  const std::string helix = "family = 'helix'\nparameters = {diameter = 50, pitch = 33}\n";
  const std::string section =
      "vertices = 60\nsection = {shape = 'rectangle', width = 0.1, height = 1}\n";
  const std::string rest =
      "rest = {family = 'helix', parameters = {diameter = 50, pitch = 33}, vertices = 60, "
      "director = [1, 0.3, 0]}\n";
  const auto scene = scene_of_text(folder, "[[rod]]\n" + helix + section + rest);
  const auto problem = prepared_of(scene).problem;
  const equilibrium::System system(problem.structure);
  CHECK(system.energy(problem.start) < 1e-12);
  CHECK(system.gradient(problem.start).norm() < 1e-7);
  CHECK(released(bare(scene)).moved_percent < 1e-8);

  // From a straight line it winds up.
  model::Design straight = bare(scene);
  const double length = straight.structure.rods[0].length();
  straight.pose[0].setZero();
  straight.pose[0].row(0).setLinSpaced(0, length);
  straight.target_directors[0].resize(3, 0);
  const auto simulation = pipeline::simulate(straight);
  REQUIRE(simulation);
  CHECK(simulation->usable());
  CHECK(simulation->moved_percent > 10);
  CHECK(simulation->design.error->max_percent < 1e-6);
}

TEST_CASE("a rest curve of other vertices bends the rod alike, to second order") {
  const auto error = [](int vertices) {
    const Folder folder;
    const auto design = bare(
        folder,
        "[[rod]]\nfamily = 'ellipse'\nvertices = " + std::to_string(vertices) +
            "\nsection = {EA = 1e6, EI = [3, 1], GJ = 2}\nrest = {family = 'ellipse', vertices = " +
            std::to_string(3 * vertices + 1) + ", director = [1, 0, 0]}\n");
    return released(design).moved_percent;
  };
  check_second_order(error, 20, 0.2);
}

TEST_CASE("a rod of constant curvature rests in an arc towards its director") {
  const Folder folder;
  folder.put("line.csv", line(40, 0, 100));
  // A quarter of a circle of radius 100 / (pi / 2).
  auto held =
      bare(folder, "[[rod]]\ncurve = 'line.csv'\ndirector = [0, 1, 0]\nrest = {curvature = " +
                       text(pi / 200) + "}\n");
  held.structure.pins = {{.rod = 0, .vertex = 0}, {.rod = 0, .vertex = 1}};
  const Eigen::Matrix3Xd pose = released(held).design.pose[0];
  const Eigen::Vector3d first = pose.col(1) - pose.col(0);
  const Eigen::Vector3d last = pose.col(40) - pose.col(39);
  CHECK(first.normalized().dot(last.normalized()) ==
        Approx(std::cos(pi / 2 * 39 / 40)).margin(1e-6));
  CHECK(last.y() > 0.9 * last.norm());
}

TEST_CASE("a ring glued after Michell's turns of twist leaves its plane") {
  const double michell = std::sqrt(3.0) * 1.3;  // EI / GJ of a round section with poisson = 0.3
  const auto critical = [&](int vertices) {
    const Folder folder;
    double stable = 0.9 * michell;
    double unstable = 1.2 * michell;
    while (unstable - stable > 1e-5) {
      const double turns = (stable + unstable) / 2;
      auto problem =
          problem_of(folder, "[[rod]]\nfamily = 'circle'\nvertices = " + std::to_string(vertices) +
                                 "\nclosing_turns = " + text(turns) + "\n");
      problem.structure.planar = true;
      const auto flat = equilibrium::solve(equilibrium::System(problem.structure), problem.start);
      REQUIRE(flat.usable());
      problem.structure.planar = false;
      const auto stability =
          equilibrium::stability(equilibrium::System(problem.structure), flat.state);
      REQUIRE(stability.computed);
      (stability.negative == 0 ? stable : unstable) = turns;
    }
    return stable / michell - 1;
  };
  check_second_order(critical, 30, 0.02);
}

TEST_CASE("twisted rods rest where their file says") {
  const Folder folder;
  const std::string section = GENERATE("{shape = 'rectangle', width = 0.1, height = 0.3}",
                                       "{shape = 'circle', radius = 0.1}");
  const std::string turns = GENERATE("0.5", "1.5");
  CAPTURE(section, turns);
  // Pinned, since an even band can pass its half turn on along itself at no cost.
  const auto design =
      bare(folder,
           "pinned = [{rod = 0, vertex = 0}, {rod = 0, vertex = 13}, {rod = 0, vertex = 27}]\n"
           "[[rod]]\nfamily = 'ellipse'\nvertices = 40\nclosing_turns = " +
               turns + "\nsection = " + section + "\n");
  const auto first = released(design);
  REQUIRE_FALSE(io::write_design(folder / "design.json", first.design));
  const auto read = io::read_design(folder / "design.json");
  REQUIRE(read);
  const auto again = pipeline::simulate(*read);
  REQUIRE(again);
  CHECK(again->usable());
  CHECK(again->iterations <= 1);
  CHECK(again->moved_percent < 1e-6);
  CHECK(released(*read).iterations == first.iterations);
}

TEST_CASE("loads that nothing holds are refused before any work") {
  const Folder folder;
  const std::string rod = "[[rod]]\nfamily = 'circle'\nvertices = 12\nsection = {density = 1000}\n";
  const auto error = [&](const std::string& toml) {
    const auto result = pipeline::prepare(scene_of_text(folder, toml + rod));
    return result ? std::string("no error") : folder.local(result.error().text());
  };
  const std::string remedy =
      ": nothing holds the rods against it, so they have no equilibrium; pin vertices, or give "
      "anchors for cables";
  const std::string gravity = "gravity = [0, 0, -9.81]\n";
  CHECK(error(gravity) == "scene.toml: gravity" + remedy);
  CHECK(error("loads = [{rod = 0, s = 1, force = [1, 0, 0]}]\n") == "scene.toml: loads" + remedy);
  CHECK(error(gravity + "pinned = [{rod = 0, vertex = 0, axes = 'xy'}]\n") ==
        "scene.toml: gravity" + remedy);
  CHECK(error(gravity + "pinned = [{rod = 0, vertex = 0}]\n") == "no error");
  CHECK(error(gravity + "anchors = [[0, 0, 50]]\n") == "no error");
}
