// Cases at the edge of what double precision tells. `tencer stress` runs many more.
#include <catch2/catch.hpp>
#include <tencer/equilibrium/inextensible.hpp>
#include <tencer/equilibrium/solve.hpp>
#include <tencer/equilibrium/stability.hpp>

#include "models.hpp"

using namespace tencer;
using namespace tencer::equilibrium;
using std::numbers::pi;

namespace {

der::Rod softer(der::Rod rod, double ratio) {
  rod.section.EA /= ratio;
  rod.section.EI1 /= ratio;
  rod.section.EI2 /= ratio;
  rod.section.GJ /= ratio;
  return rod;
}

Eigen::Matrix3Xd arch(int vertices, double span, double height) {
  Eigen::Matrix3Xd x = models::straight(vertices, span);
  for (int i = 0; i < vertices; ++i) x(1, i) = height * std::sin(pi * x(0, i) / span);
  return x;
}

// A hinged column of EI = 1 at the given multiple of the load that buckles it, still straight.
struct Column {
  model::Structure structure;
  model::State state;
  double eigenvalue;  // smallest, over EI / L^4
};

Column column(double load_ratio, double length = 1.0) {
  const int edges = 20;
  model::Structure structure{.rods = {models::slender_rod(false, edges + 1, length, 100)},
                             .pins = {{.rod = 0, .vertex = 0}, {.rod = 0, .vertex = edges}}};
  const double l = length / edges;
  const double EA = structure.rods[0].section.EA;
  const double s = 2 - 2 * std::cos(pi / edges);
  const double critical = 2 * s / (l * l) / (1 + std::sqrt(1 - 4 * s / (l * l * EA)));
  const double load = load_ratio * critical;
  const double e = l * (1 - load / EA);
  const double stiffness = s * s / (l * e * e) - load * s / e;
  return {structure, model::make_state(structure, {models::straight(edges + 1, edges * e)}),
          stiffness / l * std::pow(length, 4)};
}

}  // namespace

TEST_CASE("a soft rod beside a stiff one is in balance by its own measure") {
  const int n = 31;
  const der::Rod rod = models::slender_rod(false, n, 1.0, 1e3);
  const auto ends = [&](int r) {
    return std::vector<model::Pin>{{.rod = r, .vertex = 0}, {.rod = r, .vertex = n - 1}};
  };
  const auto solved = [&](const model::Structure& structure,
                          const std::vector<Eigen::Matrix3Xd>& x) {
    const Equilibrium result = solve(System(structure), model::make_state(structure, x));
    REQUIRE(result.usable());
    return result.state[0].x.row(1).maxCoeff();
  };
  const model::Structure alone{.rods = {rod}, .pins = ends(0), .planar = true};
  const double height = solved(alone, {arch(n, 0.9, 0.1)});
  model::Structure both{.rods = {softer(rod, 1e12), rod}, .pins = ends(0), .planar = true};
  for (const model::Pin& pin : ends(1)) both.pins.push_back(pin);
  // The stiff one is in balance at once.
  Eigen::Matrix3Xd line = models::straight(n, 1.0);
  line.row(1).setConstant(-0.5);
  CHECK(solved(both, {arch(n, 0.9, 0.1), line}) == Approx(height).epsilon(1e-9));
}

TEST_CASE("a group whose longest rod is straight may turn about it, and nothing else is singular") {
  const int n = 21;
  model::Structure structure{
      .rods = {models::slender_rod(false, n, 2.0, 300), models::slender_rod(false, n, 1.0, 300)},
      .cables = {{.a = springs::OnRod{0, 0.5}, .b = springs::OnRod{1, 0.0}, .stiffness = 1e4},
                 {.a = springs::OnRod{0, 1.4}, .b = springs::OnRod{1, 1.0}, .stiffness = 1e4}}};
  Eigen::Matrix3Xd bowed = arch(n, 0.9, 0.1);
  bowed.row(0).array() += 0.5;
  const System system(structure);
  const Equilibrium result =
      solve(system, model::make_state(structure, {models::straight(n, 2.0), bowed}));
  CHECK(result.usable());
  CHECK(stability(system, result.state).stable());
}

TEST_CASE("a ring of ten thousand vertices and one of three come to rest as regular polygons") {
  for (const int n : {3, 10000}) {
    model::Structure ring{.rods = {models::slender_rod(true, n, 1.0, 1e3)}};
    Eigen::Matrix3Xd x = models::polygon(n, 1.0);
    x.row(0) *= 1.2;
    x.row(1) *= 0.8;
    const Equilibrium result = solve(System(ring), model::make_state(ring, {x}));
    CAPTURE(n, describe(result.reason));
    REQUIRE(result.usable());
    CHECK(result.energy == Approx(2 * std::pow(n * std::tan(pi / n), 2)).epsilon(1e-11));
  }
}

TEST_CASE("rings tied at one point turn about it and are not called stable") {
  const int n = 40;
  model::Structure rings{
      .rods = {models::slender_rod(true, n, 1.0, 1e3), models::slender_rod(true, n, 1.0, 1e3)},
      .cables = {{.a = springs::OnRod{0, 0.0}, .b = springs::OnRod{1, 0.5}, .stiffness = 100}}};
  Eigen::Matrix3Xd second = models::polygon(n, 1.0);
  second.row(2) = second.row(1);
  second.row(1).setZero();
  second.row(0).array() += 0.3;
  const System system(rings);
  const Equilibrium result =
      solve(system, model::make_state(rings, {models::polygon(n, 1.0), second}));
  CHECK(result.reason == Reason::neutral);
  CHECK_FALSE(stability(system, result.state).stable());
}

TEST_CASE(
    "a very slender rod on a rigid string is certified although its axial force is rounding") {
  const int n = 41;
  model::Structure bow{
      .rods = {models::slender_rod(false, n, 1.0, 1e6)},
      .cables = {{.a = springs::OnRod{0, 0.0}, .b = springs::OnRod{0, 1.0}, .rest_length = 0.93}}};
  const InextensibleEquilibrium form =
      relax_inextensible(bow, model::make_state(bow, {arch(n, 0.93, 0.1)}));
  REQUIRE(form.equilibrium.usable());
  const Assessment assessment = assess(bow, form.equilibrium.state, form.tensions);
  CHECK(assessment.residual > 1e-6);
  CHECK(assessment.certified());

  // Not so a state that really is out of balance.
  model::State elsewhere = form.equilibrium.state;
  elsewhere[0].x.row(1) *= 1.001;
  CHECK_FALSE(assess(bow, elsewhere, form.tensions).certified());
}

TEST_CASE("a straight column is told from a buckling one within 1e-9 of Euler's load") {
  for (const double ratio : {1 - 1e-9, 1 + 1e-9}) {
    const Column at = column(ratio);
    const Stability found = stability(System(at.structure), at.state);
    REQUIRE(found.computed);
    CHECK(found.stable() == (ratio < 1));
    CHECK(found.smallest_eigenvalue == Approx(at.eigenvalue).epsilon(0.01));
  }
  const Column at = column(1.0);
  CHECK_FALSE(stability(System(at.structure), at.state).stable());
  CHECK_FALSE(solve(System(at.structure), at.state).usable());
}

TEST_CASE("a saddle is left although the energy gained is below its rounding") {
  const Column at = column(1 + 1e-9);
  const Equilibrium result = solve(System(at.structure), at.state);
  CHECK(result.usable());
  CHECK(result.escapes > 0);
  CHECK(stability(System(at.structure), result.state).stable());
  CHECK(result.state[0].x.bottomRows<2>().cwiseAbs().maxCoeff() > 1e-8);
}

TEST_CASE("the eigenvalue of an unstable state does not depend on the unit of length") {
  for (const double length : {1e-9, 1.0, 1e9}) {
    const Column at = column(1.001, length);
    const Stability found = stability(System(at.structure), at.state);
    CHECK(found.negative > 0);
    CHECK(found.smallest_eigenvalue == Approx(at.eigenvalue).epsilon(1e-5));
  }
}

TEST_CASE("a rod folded but for a millionth opens and lies straight") {
  const int n = 21;
  model::Structure rod{.rods = {models::slender_rod(false, n, 1.0, 1e3)}};
  Eigen::Matrix3Xd x = Eigen::Matrix3Xd::Zero(3, n);
  for (int i = 0; i < n; ++i) {
    const double s = i / (n - 1.0);
    x.col(i) << std::min(s, 1 - s), (s - 0.5) * 5e-7, 0;
  }
  const Equilibrium result = solve(System(rod), model::make_state(rod, {x}));
  REQUIRE(result.usable());
  CHECK((result.state[0].x.col(n - 1) - result.state[0].x.col(0)).norm() ==
        Approx(1.0).epsilon(1e-12));
}

TEST_CASE("a stiff edge off its length is not certified although balancing it turns nothing") {
  const int n = 41;
  model::Structure bow{
      .rods = {models::slender_rod(false, n, 1.0, 1e4)},
      .cables = {{.a = springs::OnRod{0, 0.0}, .b = springs::OnRod{0, 1.0}, .rest_length = 0.93}}};
  const InextensibleEquilibrium form =
      relax_inextensible(bow, model::make_state(bow, {arch(n, 0.93, 0.1)}));
  REQUIRE(form.equilibrium.usable());
  REQUIRE(assess(bow, form.equilibrium.state, form.tensions).certified());
  model::State stretched = form.equilibrium.state;
  const Eigen::Vector3d edge = stretched[0].x.col(1) - stretched[0].x.col(0);
  stretched[0].x.col(0) -= 1e-10 * edge.normalized();
  const Assessment assessment = assess(bow, stretched, form.tensions);
  CHECK(assessment.turn <= 1e-8);
  CHECK(assessment.residual > 1e-3);
  CHECK_FALSE(assessment.certified());
}
