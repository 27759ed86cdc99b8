#include <catch2/catch.hpp>
#include <tencer/equilibrium/branch.hpp>
#include <tencer/equilibrium/inextensible.hpp>
#include <tencer/equilibrium/path.hpp>

#include "fixtures/bow.hpp"
#include "models.hpp"

using namespace tencer;
using namespace tencer::equilibrium;
using fixtures::Held;
using fixtures::settled;

namespace {

constexpr int arch_vertices = 41;
constexpr double span = 0.995;

// A rod between hinges nearer to each other than it is long, bent upwards, a string at arc length s
// that holds it 2 % below where it would be, from an anchor below.
Held arch_on_string(double s) {
  const int n = arch_vertices;
  model::Structure arch{.rods = {models::slender_rod(false, n, 1.0, 1e3)},
                        .anchors = Eigen::Vector3d(s * span, -2, 0),
                        .pins = {{.rod = 0, .vertex = 0}, {.rod = 0, .vertex = n - 1}},
                        .planar = true};
  Eigen::Matrix3Xd x = models::straight(n, span);
  for (int i = 0; i < n; ++i) x(1, i) = 0.045 * std::sin(std::numbers::pi * x(0, i) / span);
  const Equilibrium free = solve(System(arch), model::make_state(arch, {x}));
  REQUIRE(free.usable());
  const double height = free.state[0].x(1, static_cast<int>(s * (n - 1)));
  arch.cables = {
      {.a = springs::OnRod{0, s}, .b = springs::AtAnchor{0}, .rest_length = 2 + 0.98 * height}};
  return settled(arch, free.state[0].x);
}

std::vector<const BranchPoint*> with(const Branch& branch, Passing passing) {
  std::vector<const BranchPoint*> found;
  for (const BranchPoint& point : branch.points)
    if (point.passing == passing) found.push_back(&point);
  return found;
}

Branch follow(const Held& start, double length, const BranchOptions& options = {}) {
  return follow_branch(start.structure, start.state, start.tensions,
                       Eigen::VectorXd::Constant(1, length), options);
}

}  // namespace

TEST_CASE("a straight rod pulled together by a string buckles at Euler's load") {
  const int n = 61;
  model::Structure strut{
      .rods = {models::slender_rod(false, n, 1.0, 100)},
      .cables = {{.a = springs::OnRod{0, 0.0}, .b = springs::OnRod{0, 1.0}, .rest_length = 1}},
      .planar = true};
  const double EA = strut.rods[0].section.EA;
  const Held start{strut, model::make_state(strut, {models::straight(n, 1 - 1 / EA)}),
                   Eigen::VectorXd::Ones(1)};
  const Branch branch = follow(start, 1 - 20 / EA);
  REQUIRE(branch.end == BranchEnd::arrived);
  const auto buckles = with(branch, Passing::branching);
  REQUIRE(buckles.size() == 1);
  CHECK(buckles[0]->tensions[0] == Approx(std::numbers::pi * std::numbers::pi).epsilon(1e-3));
  CHECK(buckles[0]->negative == 1);
  CHECK(branch.points.front().negative == 0);
  CHECK(branch.points.back().tensions[0] == Approx(20).epsilon(1e-6));
}

TEST_CASE("an arch pulled down in its middle gives way to its second mode") {
  const Held start = arch_on_string(0.5);
  const double height = (start.structure.cables[0].rest_length - 2) / 0.98;
  const Branch branch = follow(start, 2 + 0.8 * height, {.max_step = 0.02, .stable_only = true});
  REQUIRE(branch.end == BranchEnd::unstable);
  const auto gives_way = with(branch, Passing::branching);
  REQUIRE(gives_way.size() == 1);
  // Where its thrust is that of Euler's second load, see the tests of path.hpp.
  CHECK((0.98 - 0.18 * gives_way[0]->part) ==
        Approx(std::numbers::pi / std::sqrt(12.0)).epsilon(0.005));
}

TEST_CASE("where a string goes slack at an unstable pose the way turns back") {
  const Held start = arch_on_string(0.475);
  const double length = start.structure.cables[0].rest_length;
  const Branch branch = follow(start, 2 - 0.5 * (length - 2), {.max_step = 0.01});
  const auto turns = with(branch, Passing::turning);
  REQUIRE(turns.size() == 1);
  CHECK(turns[0]->negative == 1);
  CHECK(turns[0]->tensions[0] == 0);
  CHECK_FALSE(turns[0]->forward);
  CHECK(branch.end == BranchEnd::back);
  CHECK(branch.points.back().part == Approx(0).margin(1e-9));
}

TEST_CASE("a branch goes on around its turning points, and costs the work of its cables") {
  // The string goes to the middle of another rod, a soft spring, whose ends two strings pull down.
  const int n = 21;
  const double depth = 0.3, half = 0.25;
  Held start = arch_on_string(0.475);
  model::Structure two = start.structure;
  two.rods.push_back(models::slender_rod(false, n, 2 * half, 1e3));
  two.rods[1].section.EI1 = two.rods[1].section.EI2 = 0.05;
  const double middle = 0.475 * span;
  two.anchors = Eigen::Matrix3Xd(3, 2);
  two.anchors.col(0) << middle - half, -1, 0;
  two.anchors.col(1) << middle + half, -1, 0;
  Eigen::Matrix3Xd below = models::straight(n, 2 * half);
  below.row(0).array() += middle - half;
  below.row(1).array() -= depth;
  const auto& up = start.state[0].x;
  two.cables = {
      {.a = springs::OnRod{0, 0.475},
       .b = springs::OnRod{1, half},
       .rest_length = depth + up.row(1).maxCoeff() - 0.001},
      {.a = springs::OnRod{1, 0}, .b = springs::AtAnchor{0}, .rest_length = 1 - depth},
      {.a = springs::OnRod{1, 2 * half}, .b = springs::AtAnchor{1}, .rest_length = 1 - depth}};
  auto rest = relax_inextensible(two, model::make_state(two, {up, below}));
  REQUIRE(rest.equilibrium.usable());
  REQUIRE(rest.tensions.minCoeff() > 0);
  const Eigen::Vector3d lengths(two.cables[0].rest_length, 1 - depth, 1 - depth);
  const Eigen::Vector3d far = lengths - Eigen::Vector3d(0, 0.18, 0.18);
  const Branch branch =
      follow_branch(two, rest.equilibrium.state, rest.tensions, far, {.max_step = 0.005});
  const auto turns = with(branch, Passing::turning);
  REQUIRE(turns.size() >= 1);
  CHECK_FALSE(turns[0]->forward);
  CHECK(turns[0]->negative == 1);
  CHECK(turns[0]->tensions.minCoeff() > 0);
  // Where the stable path ends that path.hpp follows.
  const PathEquilibrium path =
      settle_along(PathStart(two, rest.equilibrium.state, rest.tensions), far);
  REQUIRE(path.fold_at);
  CHECK(turns[0]->part == Approx(*path.fold_at).margin(2e-3));
  // dE = -tension dl, by the trapezoidal rule, there and back.
  double work = 0;
  for (std::size_t i = 1; i < branch.points.size(); ++i) {
    const BranchPoint& before = branch.points[i - 1];
    const BranchPoint& after = branch.points[i];
    work -= (before.tensions + after.tensions).dot(far - lengths) / 2 * (after.part - before.part);
    const double gained = after.energy - branch.points.front().energy;
    CHECK(work == Approx(gained).epsilon(5e-3).margin(1e-5));
  }
}

TEST_CASE("frames are at equal parts of the way, and a ring leaves its plane where it does") {
  model::Structure ring = models::ring_with_cable(60, 0.0, 0.95 / std::numbers::pi);
  const Held start = settled(ring, models::polygon(60, 1.0));
  const Branch branch = follow(start, 0.3 / std::numbers::pi, {.frames = 5});
  REQUIRE(branch.end == BranchEnd::arrived);
  std::vector<double> frames;
  for (const BranchPoint& point : branch.points)
    if (point.frame) frames.push_back(point.part);
  REQUIRE(frames.size() == 6);
  for (std::size_t k = 0; k < frames.size(); ++k)
    CHECK(frames[k] == Approx(0.2 * static_cast<double>(k)).margin(1e-12));
  const auto leaves = with(branch, Passing::branching);
  REQUIRE(leaves.size() == 1);
  // Independently: the sign of the smallest eigenvalue on either side.
  const auto negative = [&](double part) {
    model::Structure flat = ring;
    flat.cables[0].rest_length = (0.95 - 0.65 * part) / std::numbers::pi;
    flat.planar = true;
    const Held there = settled(flat, models::polygon(60, 1.0));
    flat.planar = false;
    return assess(flat, there.state, there.tensions).stability.negative;
  };
  CHECK(negative(leaves[0]->part - 1e-3) == 0);
  CHECK(negative(leaves[0]->part + 1e-3) == 1);
}

TEST_CASE("cables go slack and taut along a branch") {
  model::Structure ring = models::ring_with_cable(40, 0.0, 0.28);
  ring.planar = true;
  ring.cables.push_back(
      {.a = springs::OnRod{0, 0.05}, .b = springs::OnRod{0, 0.45}, .rest_length = 0.27});
  const Held start = settled(ring, models::polygon(40, 1.0));
  REQUIRE(start.tensions.minCoeff() > 0);
  const Branch there =
      follow_branch(start.structure, start.state, start.tensions, Eigen::Vector2d(0.28, 0.3));
  REQUIRE(there.end == BranchEnd::arrived);
  CHECK(with(there, Passing::slack).size() == 1);
  CHECK(there.points.back().tensions[1] == 0);
  model::Structure loose = ring;
  loose.cables[1].rest_length = 0.3;
  const Branch back = follow_branch(loose, there.points.back().state, there.points.back().tensions,
                                    Eigen::Vector2d(0.28, 0.27));
  REQUIRE(back.end == BranchEnd::arrived);
  CHECK(with(back, Passing::taut).size() == 1);
  CHECK((back.points.back().tensions - start.tensions).norm() < 1e-5 * start.tensions.norm());
}

TEST_CASE("branch options out of range are refused") {
  const Held start = arch_on_string(0.5);
  for (const BranchOptions& options : {BranchOptions{.max_step = 0}, BranchOptions{.min_step = 0},
                                       BranchOptions{.frames = 0}, BranchOptions{.max_points = 0}})
    CHECK_THROWS_AS(follow(start, 1.9, options), std::invalid_argument);
  CHECK_THROWS_AS(follow(start, 0.0), std::invalid_argument);
  CHECK_THROWS_AS(follow_branch(start.structure, start.state, Eigen::VectorXd::Zero(2),
                                Eigen::VectorXd::Ones(1)),
                  std::invalid_argument);
}
