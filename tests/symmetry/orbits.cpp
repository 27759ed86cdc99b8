#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <set>
#include <tencer/symmetry/orbit.hpp>
#include <tencer/symmetry/tie.hpp>

#include "figures.hpp"

namespace tencer::symmetry {
namespace {

using springs::AtAnchor;
using springs::Cable;
using springs::OnRod;
using springs::ParameterKind;

std::vector<Cable> moved_to(std::vector<Cable> cables, const Ties& ties, const Eigen::VectorXd& p) {
  for (int i = 0; i < p.size(); ++i) {
    const auto [kind, cable] = ties.parameters[i];
    if (kind == ParameterKind::stiffness)
      cables[cable].stiffness = p[i];
    else
      std::get<OnRod>(kind == ParameterKind::position_a ? cables[cable].a : cables[cable].b).s =
          p[i];
  }
  return cables;
}

Eigen::VectorXd parameters_of(const std::vector<Cable>& cables, const Ties& ties) {
  Eigen::VectorXd p(std::ssize(ties.parameters));
  for (int i = 0; i < p.size(); ++i) {
    const auto [kind, cable] = ties.parameters[i];
    p[i] =
        kind == ParameterKind::stiffness
            ? cables[cable].stiffness
            : std::get<OnRod>(kind == ParameterKind::position_a ? cables[cable].a : cables[cable].b)
                  .s;
  }
  return p;
}

// The group maps the set of cables to itself: places (rounded off) and stiffnesses.
void check_invariant(const std::vector<Cable>& cables, const Group& group) {
  const auto distance = [&](const springs::End& a, const springs::End& b) {
    if (a.index() != b.index()) return 1.0;
    if (const auto* anchor = std::get_if<AtAnchor>(&a))
      return anchor->anchor == std::get<AtAnchor>(b).anchor ? 0.0 : 1.0;
    const auto& on_a = std::get<OnRod>(a);
    const auto& on_b = std::get<OnRod>(b);
    if (on_a.rod != on_b.rod) return 1.0;
    const auto& rod = group.rods[on_a.rod];
    return std::abs(rod.closed() ? std::remainder(on_a.s - on_b.s, rod.length())
                                 : on_a.s - on_b.s) /
           rod.length();
  };
  for (const Operation& operation : group.operations) {
    for (const Cable& cable : cables) {
      const Cable to = image(operation, cable, group.rods);
      int matches = 0;
      for (const Cable& other : cables) {
        const bool same = std::max(distance(to.a, other.a), distance(to.b, other.b)) < 1e-9 ||
                          std::max(distance(to.a, other.b), distance(to.b, other.a)) < 1e-9;
        if (same && std::abs(to.stiffness - other.stiffness) < 1e-12) ++matches;
      }
      REQUIRE(matches == 1);
    }
  }
}

// A ring of 4 (arc length from (radius, 0, 0)) with the mirror across y = 0: s -> -s.
struct MirroredRing {
  Figure figure = figure_of({curves::circle(4.0, 100)});
  double length = figure.rods[0].length();
  Group group =
      verify(figure, std::vector<model::SymmetryGenerator>{Reflection{.normal = {0, 1, 0}}})->group;
};

}  // namespace

TEST_CASE("the orbit of a cable has an image for each operation") {
  std::mt19937 random(1);
  for (const int vertices : {100, 102, 401}) {
    const Figure figure = trefoil(vertices);
    // Where vertices do not fall onto vertices, each of the four ends can be off the smooth curve
    // by a sagitta, an eighth of the second difference.
    const Eigen::Matrix3Xd edges = geometry::edge_vectors(figure.curves[0]);
    const double second =
        (edges.rightCols(vertices - 1) - edges.leftCols(vertices - 1)).colwise().norm().maxCoeff();
    const double allowed = vertices == 102 ? 1e-6 : 4.0 * second / 8.0;
    const Group group = detect(figure).group;
    REQUIRE(group.order() == 6);
    for (int trial = 0; trial < 20; ++trial) {
      const Cable cable = random_cable(random, figure);
      const std::vector<Cable> cables = orbit(cable, group);
      REQUIRE(cables.size() == 6);
      CHECK(std::get<OnRod>(cables[0].a).s == Approx(std::get<OnRod>(cable.a).s).epsilon(1e-12));
      for (const Cable& other : cables) {
        CHECK(std::abs(span(figure, other) - span(figure, cable)) < allowed);
        CHECK(other.stiffness == cable.stiffness);
        CHECK(other.rest_length == cable.rest_length);
      }
      check_invariant(cables, group);
    }
  }
}

TEST_CASE("a cable turned end for end is the same cable") {
  const MirroredRing ring;
  const Cable across{.a = OnRod{0, 3.0}, .b = OnRod{0, -3.0}, .stiffness = 1.0};
  CHECK(orbit(across, ring.group).size() == 1);
  // Nearly so: it is moved to where it is so exactly.
  const Cable nearly{.a = OnRod{0, 3.0}, .b = OnRod{0, ring.length - 3.001}, .stiffness = 1.0};
  const std::vector<Cable> moved = orbit(nearly, ring.group);
  REQUIRE(moved.size() == 1);
  CHECK(std::get<OnRod>(moved[0].a).s == Approx(3.0005).epsilon(1e-9));
  CHECK(std::get<OnRod>(moved[0].b).s == Approx(ring.length - 3.0005).epsilon(1e-9));
  // Further off it is another cable than its image.
  const Cable apart{.a = OnRod{0, 3.0}, .b = OnRod{0, ring.length - 3.1}, .stiffness = 1.0};
  CHECK(orbit(apart, ring.group).size() == 2);
}

TEST_CASE("a cable in a mirror plane is its own image, also where the seam is in the plane") {
  const MirroredRing ring;
  for (const double s : {0.0, 1e-7, ring.length - 1e-7, ring.length}) {
    const Cable cable{.a = OnRod{0, s}, .b = OnRod{0, ring.length / 2}, .stiffness = 1.0};
    CHECK(orbit(cable, ring.group).size() == 1);
    const Ties ties = tie_cables(std::vector<Cable>{cable}, ring.group);
    CHECK(ties.matrix.rows() == 3);
    CHECK(ties.matrix.cols() == 1);
  }
  // One end at the seam, the other off the plane: two cables that meet there.
  const Cable leaning{.a = OnRod{0, 0.0}, .b = OnRod{0, 5.0}, .stiffness = 1.0};
  const std::vector<Cable> pair = orbit(leaning, ring.group);
  REQUIRE(pair.size() == 2);
  CHECK(std::get<OnRod>(pair[1].b).s == Approx(ring.length - 5.0).epsilon(1e-9));
}

TEST_CASE("a cable that is its own image keeps one free position or none") {
  const MirroredRing ring;
  const std::vector<Cable> cables{
      {.a = OnRod{0, 3.0}, .b = OnRod{0, -3.0}, .stiffness = 1.0},
      {.a = OnRod{0, 0.0}, .b = OnRod{0, ring.length / 2}, .stiffness = 2.0},
      {.a = OnRod{0, 0.0}, .b = OnRod{0, 5.0}, .stiffness = 3.0}};
  const Ties ties = tie_cables(cables, ring.group);
  REQUIRE(ties.parameters.size() == 9);
  REQUIRE(ties.free.size() == 2 + 1 + 3);
  const Eigen::MatrixXd matrix = ties.matrix;
  CHECK(ties.free[1].kind == ParameterKind::position_a);
  CHECK(matrix(1, 1) == 1.0);
  CHECK(matrix(2, 1) == -1.0);
  CHECK(std::abs(ties.offset[1]) < 1e-9);
  CHECK(std::abs(ties.offset[2]) < 1e-9);
  CHECK(matrix.row(4).isZero());
  CHECK(matrix.row(5).isZero());
  CHECK(ties.offset[5] == Approx(ring.length / 2).epsilon(1e-9));
  CHECK(matrix.bottomRightCorner(3, 3).isIdentity());
}

TEST_CASE("free variables reproduce orbits and keep them symmetric as they slide") {
  std::mt19937 random(2);
  const std::vector<Figure> figures{trefoil(100), figure_of(curves::twin_trefoils(3, 1.2, 101)),
                                    figure_of(curves::borromean_ellipses(5, 3, 98)),
                                    figure_of({curves::helix(8.0, 2.0, 3.25, 100)})};
  for (const Figure& figure : figures) {
    const Group group = detect(figure).group;
    REQUIRE(group.order() > 1);
    std::vector<Cable> cables;
    for (int i = 0; i < 5; ++i) cables.push_back(random_cable(random, figure));
    cables = complete(cables, group);
    REQUIRE(static_cast<int>(cables.size()) == 5 * group.order());
    // Ends swapped and other turns of closed rods, as a file may give them.
    for (Cable& cable : cables) {
      if (random() % 2 == 0) std::swap(cable.a, cable.b);
      auto& end = std::get<OnRod>(cable.a);
      if (group.rods[end.rod].closed() && random() % 2 == 0)
        end.s -= 2.0 * group.rods[end.rod].length();
    }
    const Ties ties = tie_cables(cables, group);
    const Eigen::VectorXd p = parameters_of(cables, ties);
    REQUIRE(ties.free.size() == 15);
    Eigen::VectorXd z = project(ties, p);
    CHECK((ties.matrix * z + ties.offset - p).cwiseAbs().maxCoeff() < 1e-9);
    // z holds parameters of the orbits' first cables.
    for (std::size_t j = 0; j < ties.free.size(); ++j) {
      const auto row = std::find_if(
          ties.parameters.begin(), ties.parameters.end(), [&](const springs::Parameter& parameter) {
            return parameter.kind == ties.free[j].kind && parameter.cable == ties.free[j].cable;
          });
      CHECK(std::abs(z[j] - p[row - ties.parameters.begin()]) < 1e-9);
    }
    // Small steps, but over several cells of arc length and over seams.
    for (int j = 0; j < z.size(); ++j)
      z[j] += (ties.free[j].kind == ParameterKind::stiffness ? 0.3 : 0.02) *
              std::uniform_real_distribution<>(-1, 1)(random);
    check_invariant(moved_to(cables, ties, ties.matrix * z + ties.offset), group);
  }
}

TEST_CASE("sliding across the seam stays symmetric") {
  const Figure figure = trefoil(102);
  const Group group =
      verify(figure, std::vector<model::SymmetryGenerator>{Rotation{.fold = 3}})->group;
  const double length = figure.rods[0].length();
  const std::vector<Cable> cables =
      orbit({.a = OnRod{0, length - 0.01}, .b = OnRod{0, 0.4 * length}, .stiffness = 1.0}, group);
  REQUIRE(cables.size() == 3);
  const Ties ties = tie_cables(cables, group);
  Eigen::VectorXd z = project(ties, parameters_of(cables, ties));
  z[1] += 0.5;
  const std::vector<Cable> slid = moved_to(cables, ties, ties.matrix * z + ties.offset);
  CHECK(std::get<OnRod>(slid[0].a).s == Approx(length + 0.49).epsilon(1e-12));
  for (const Cable& cable : slid)
    CHECK(span(figure, cable) == Approx(span(figure, slid[0])).epsilon(1e-6));
}

TEST_CASE("projecting averages what is nearly symmetric") {
  const Figure figure = trefoil(102);
  const Group group = detect(figure).group;
  std::mt19937 random(4);
  const std::vector<Cable> cables = orbit(random_cable(random, figure), group);
  const Ties ties = tie_cables(cables, group);
  const Eigen::VectorXd p = parameters_of(cables, ties);
  std::normal_distribution<double> noise(0.0, 1e-2);
  Eigen::VectorXd rough = p;
  for (double& value : rough) value += noise(random);
  const Eigen::VectorXd z = project(ties, rough);
  double sum = 0.0;
  for (int i = 0; i < p.size(); ++i)
    if (ties.parameters[i].kind == ParameterKind::stiffness) sum += rough[i];
  CHECK(z[0] == Approx(sum / 6).epsilon(1e-14));
  // The residual is perpendicular to all symmetric changes.
  const Eigen::VectorXd residual = rough - ties.matrix * z - ties.offset;
  CHECK((ties.matrix.transpose() * residual).norm() < 1e-12);
  CHECK(residual.norm() > 1e-3);
}

TEST_CASE("rest lengths may be what symmetric cables share") {
  const Figure figure = trefoil(102);
  const Group group = detect(figure).group;
  std::mt19937 random(4);
  const std::vector<Cable> cables = orbit(random_cable(random, figure), group);
  const Ties ties = tie_cables(cables, group, ParameterKind::rest_length);
  CHECK(ties.parameters[0].kind == ParameterKind::rest_length);
  CHECK(ties.free[0].kind == ParameterKind::rest_length);
  CHECK(ties.matrix.isApprox(tie_cables(cables, group).matrix));
  CHECK_THROWS_AS(tie_cables(cables, group, ParameterKind::position_b), std::invalid_argument);
}

TEST_CASE("completing a network adds what is missing and doubles nothing") {
  const Figure figure = figure_of(curves::borromean_ellipses(5.0, 3.0, 100));
  const Group group = detect(figure).group;
  REQUIRE(group.order() == 24);
  std::mt19937 random(6);
  const Cable one = random_cable(random, figure);
  Cable two = image(group.operations[5], one, group.rods);
  two.stiffness = one.stiffness + 1.0;
  std::swap(two.a, two.b);
  const Cable three = random_cable(random, figure);
  const std::vector<Cable> network = complete(std::vector<Cable>{one, three, two}, group);
  REQUIRE(network.size() == 48);
  CHECK(network[0].stiffness == Approx(one.stiffness + 0.5).epsilon(1e-14));
  CHECK(network[24].stiffness == three.stiffness);
  check_invariant(network, group);
  CHECK(complete(network, group).size() == 48);
  const Ties ties = tie_cables(network, group);
  CHECK(ties.free.size() == 6);
  CHECK(std::set<int>(ties.orbit.begin(), ties.orbit.end()).size() == 2);
}

TEST_CASE("cables to anchors") {
  Figure figure = figure_of({curves::helix(8.0, 2.0, 3.0, 100)});
  // The helix starts at (4, 0, 0) and ends above: its 2-fold axis lies along x at half height.
  figure.anchors.resize(3, 3);
  figure.anchors << 9, 2, 2, 0, 7, -7, 3, 5, 1;
  const auto found = verify(
      figure, std::vector<model::SymmetryGenerator>{Rotation{
                  .fold = 2, .axis = Eigen::Vector3d::UnitX(), .point = Eigen::Vector3d(0, 0, 3)}});
  REQUIRE(found);
  const Group& group = found->group;
  REQUIRE(group.order() == 2);
  const double length = figure.rods[0].length();
  // The first anchor is on the axis, the others change places.
  const std::vector<Cable> network =
      complete(std::vector<Cable>{{.a = AtAnchor{0}, .b = OnRod{0, 2.0}, .stiffness = 1.0},
                                  {.a = AtAnchor{1}, .b = OnRod{0, 3.0}, .stiffness = 1.0},
                                  {.a = AtAnchor{0}, .b = OnRod{0, length / 2}, .stiffness = 1.0}},
               group);
  REQUIRE(network.size() == 5);
  CHECK(std::get<OnRod>(network[1].b).s == Approx(length - 2.0).epsilon(1e-9));
  CHECK(std::get<AtAnchor>(network[3].a).anchor == 2);
  for (const int i : {0, 2})
    CHECK(span(figure, network[i]) == Approx(span(figure, network[i + 1])).epsilon(1e-9));
  const Ties ties = tie_cables(network, group);
  // Five cables with one position each; two orbits slide, the cable on the axis does not.
  CHECK(ties.parameters.size() == 10);
  CHECK(ties.free.size() == 5);
  CHECK_THROWS_AS(tie_cables(std::vector<Cable>{{.a = AtAnchor{3}, .b = OnRod{0, 1.0}}}, group),
                  std::invalid_argument);
}

TEST_CASE("no symmetry leaves every parameter free") {
  std::mt19937 random(9);
  const Figure figure = figure_of({random_curve(random, 100)});
  const Group group = verify(figure, {})->group;
  std::vector<Cable> cables;
  for (int i = 0; i < 4; ++i) cables.push_back(random_cable(random, figure));
  CHECK(complete(cables, group).size() == 4);
  const Ties ties = tie_cables(cables, group);
  CHECK(Eigen::MatrixXd(ties.matrix).isIdentity());
  CHECK(ties.offset.isZero());
}

TEST_CASE("cables may be written at either end of a tolerance cell") {
  // Ends that differ by less than the tolerance are one place wherever they lie, the seam and the
  // ends of an open rod included.
  for (const bool closed : {true, false}) {
    const geometry::ArcLength rod(Eigen::VectorXd::Constant(10, 0.37), closed);
    Group group{.rods = {rod}, .operations = {identity(1, 0)}, .product = {}};
    group.product.setZero(1, 1);
    std::mt19937 random(13);
    const double length = rod.length();
    for (int trial = 0; trial < 2000; ++trial) {
      double s = std::uniform_real_distribution<>(0.0, length)(random);
      if (trial % 4 == 0) s = 0.0;
      if (trial % 4 == 1) s = length * (1.0 - 1e-15);
      const double near = s + 0.9e-4 * length * std::uniform_real_distribution<>(-1, 1)(random);
      const Cable first{.a = OnRod{0, s}, .b = OnRod{0, 1.0}, .stiffness = 1.0};
      const Cable second{.a = OnRod{0, 1.0}, .b = OnRod{0, near}, .stiffness = 3.0};
      const Cable third{.a = OnRod{0, 1.0}, .b = OnRod{0, s + 2e-4 * length}, .stiffness = 3.0};
      REQUIRE(complete(std::vector<Cable>{first, second}, group).size() == 1);
      if (closed) REQUIRE(complete(std::vector<Cable>{first, third}, group).size() == 2);
    }
  }
}

}  // namespace tencer::symmetry
