#include "multilevel/canonical.hpp"

#include <Eigen/Geometry>
#include <catch2/catch.hpp>
#include <random>

#include "fixtures/problems.hpp"
#include "multilevel/coarsen.hpp"

using namespace tencer;
using namespace tencer::fixtures;
using elimination::Canonical;
using elimination::coarsened;
using ground_structure::Problem;

namespace {

// A closed curve without symmetry and an open one beside it.
std::vector<geometry::Polyline> shape() {
  geometry::Polyline knot = curves::trefoil(curves::TrefoilForm::hypotrochoid, 1.0, 120);
  for (auto point : knot.points.colwise())
    point += 0.2 * Eigen::Vector3d(std::sin(point.y()), std::cos(2 * point.x()), point.x());
  geometry::Polyline bow = curves::circle(0.8, 90);
  bow.closed = false;
  bow.points.row(2).setLinSpaced(0.3, 1.5);
  return {knot, bow};
}

std::vector<geometry::Polyline> turned(std::vector<geometry::Polyline> curves) {
  const Eigen::Matrix3d turn =
      Eigen::AngleAxisd(1.1, Eigen::Vector3d(1, 2, -0.5).normalized()).toRotationMatrix();
  for (auto& curve : curves) curve.points = turn * curve.points;
  return curves;
}

std::vector<geometry::Polyline> reversed(std::vector<geometry::Polyline> curves) {
  for (auto& curve : curves) curve.points = curve.points.rowwise().reverse().eval();
  return curves;
}

std::vector<geometry::Polyline> counted_from(int first, std::vector<geometry::Polyline> curves) {
  const Eigen::Matrix3Xd before = curves[0].points;
  const Eigen::Index n = before.cols();
  for (Eigen::Index i = 0; i < n; ++i) curves[0].points.col(i) = before.col((i + first) % n);
  return curves;
}

std::vector<geometry::Polyline> shaken(std::vector<geometry::Polyline> curves) {
  std::mt19937_64 random(1);
  std::uniform_real_distribution<double> shake(-1e-9, 1e-9);
  for (auto& curve : curves)
    curve.points = curve.points.unaryExpr([&](double x) { return x + shake(random); });
  return curves;
}

Problem problem_of_curves(const std::vector<geometry::Polyline>& curves) {
  return problem_of(make_model(curves));
}

}  // namespace

TEST_CASE("The same shape is the same problem, wherever it lies and however it is counted") {
  const Problem before = *coarsened(Canonical(problem_of_curves(shape())).problem(), {});
  const auto variants = {turned(shape()), reversed(shape()), counted_from(17, shape()),
                         shaken(shape()), shaken(reversed(counted_from(50, turned(shape()))))};
  for (const auto& variant : variants) {
    const Problem after = *coarsened(Canonical(problem_of_curves(variant)).problem(), {});
    for (std::size_t r = 0; r < 2; ++r) {
      CHECK(after.target.points[r] == before.target.points[r]);
      CHECK(after.structure.rods[r].rest_lengths == before.structure.rods[r].rest_lengths);
      CHECK(after.start[r].x == before.start[r].x);
    }
    REQUIRE(after.candidates.size() == before.candidates.size());
    const auto place = [](const springs::End& end) { return std::get<springs::OnRod>(end).s; };
    for (std::size_t c = 0; c < after.candidates.size(); ++c)
      CHECK(place(after.candidates[c].a) == place(before.candidates[c].a));
  }
}

TEST_CASE("Views turn with the shape") {
  Problem problem = problem_of_curves(shape());
  problem.target.views = {{.direction = {0, 0.6, 0.8}}, {.direction = {1, 0, 0}, .weight = 2}};
  Problem other = problem_of_curves(turned(shape()));
  const Eigen::Matrix3d turn =
      Eigen::AngleAxisd(1.1, Eigen::Vector3d(1, 2, -0.5).normalized()).toRotationMatrix();
  other.target.views = model::turned(problem.target.views, turn);
  const Problem before = *coarsened(Canonical(problem).problem(), {});
  const Problem after = *coarsened(Canonical(other).problem(), {});
  REQUIRE(after.target.views.size() == 2);
  for (std::size_t i = 0; i < 2; ++i) {
    CHECK(after.target.views[i].direction == before.target.views[i].direction);
    CHECK(after.target.views[i].weight == before.target.views[i].weight);
  }
  CHECK((before.target.views[1].direction - problem.target.views[1].direction).norm() > 0.1);
}

TEST_CASE("A mirror image is another problem") {
  auto mirrored = shape();
  for (auto& curve : mirrored) curve.points.row(0) *= -1;
  const Problem before = *coarsened(Canonical(problem_of_curves(shape())).problem(), {});
  const Problem after = *coarsened(Canonical(problem_of_curves(mirrored)).problem(), {});
  CHECK((after.target.points[0] - before.target.points[0]).norm() > 1e-2);
}

TEST_CASE("Networks are taken there and back, their cables between the same points") {
  const Problem problem = problem_of_curves(reversed(counted_from(17, turned(shape()))));
  const Canonical canonical(problem);
  network::Network network = problem.bare();
  for (std::size_t c = 0; c < problem.candidates.size(); c += 501) {
    network.structure.cables.push_back(problem.candidates[c]);
    network.structure.cables.back().stiffness = 1.0;
  }
  const network::Network anew = canonical.counted(network);
  CHECK((cable_lengths(anew) - cable_lengths(network)).cwiseAbs().maxCoeff() < 1e-12);
  const network::Network back = canonical.restored(anew, problem.structure);
  CHECK((cable_lengths(back) - cable_lengths(network)).cwiseAbs().maxCoeff() < 1e-12);
  for (std::size_t r = 0; r < 2; ++r) {
    CHECK((back.state[r].x - network.state[r].x).cwiseAbs().maxCoeff() < 1e-12);
    CHECK((anew.state[r].x - canonical.problem().target.points[r]).cwiseAbs().maxCoeff() < 1e-12);
  }
  for (std::size_t c = 0; c < back.structure.cables.size(); ++c) {
    const auto s = [](const springs::Cable& cable) { return std::get<springs::OnRod>(cable.a).s; };
    CHECK(s(back.structure.cables[c]) == Approx(s(network.structure.cables[c])).margin(1e-9));
  }
}

TEST_CASE("What has a symmetry to keep stays as it is given") {
  const Model model = trefoil(60);
  Problem problem = problem_of(model);
  problem.symmetry = group_of(model);
  const Canonical canonical(problem);
  CHECK(canonical.problem().target.points[0] == problem.target.points[0]);
}
