#include <Eigen/Geometry>
#include <catch2/catch.hpp>
#include <random>
#include <tencer/curves/analytic.hpp>
#include <tencer/fabricate/crossings.hpp>

using namespace tencer;
using geometry::Polyline;

namespace {

Polyline segment(const Eigen::Vector3d& from, const Eigen::Vector3d& to) {
  Polyline line{Eigen::Matrix3Xd(3, 2), false};
  line.points << from, to;
  return line;
}

}  // namespace

TEST_CASE("One line over another is a crossing, with its sign, place and height") {
  // The upper goes right, the lower up: turned to the left, the upper lies as the lower.
  const std::vector<Polyline> lines{segment({0, 1, 5}, {4, 1, 5}), segment({1, 0, 2}, {1, 4, 2})};
  const auto found = fabricate::crossings(lines, Eigen::Matrix3d::Identity());
  REQUIRE(found.size() == 1);
  CHECK(found[0].over.rod == 0);
  CHECK(found[0].over.t == Approx(0.25));
  CHECK(found[0].under.rod == 1);
  CHECK(found[0].under.t == Approx(0.25));
  CHECK(found[0].sine == Approx(1));
  CHECK(found[0].height == Approx(3));

  // From below the other one is over; the sign stays.
  const Eigen::Matrix3d below = Eigen::Vector3d(-1, 1, -1).asDiagonal().toDenseMatrix();
  const auto under = fabricate::crossings(lines, below);
  REQUIRE(under.size() == 1);
  CHECK(under[0].over.rod == 1);
  CHECK(under[0].sine == Approx(1));
}

TEST_CASE("A trefoil seen along its axis goes over and under in turn, three times") {
  const std::vector<Polyline> knot{curves::trefoil(curves::TrefoilForm::hypotrochoid, 1.0, 100)};
  const Eigen::Matrix3d tilted =
      Eigen::AngleAxisd(0.05, Eigen::Vector3d(1, 0.3, 0).normalized()).toRotationMatrix();
  const auto found = fabricate::crossings(knot, tilted);
  REQUIRE(found.size() == 3);
  std::vector<std::pair<double, bool>> along;
  for (const auto& c : found) {
    CHECK(c.sine * found[0].sine > 0);
    along.emplace_back(c.over.edge + c.over.t, true);
    along.emplace_back(c.under.edge + c.under.t, false);
  }
  std::ranges::sort(along);
  for (std::size_t i = 1; i < along.size(); ++i) CHECK(along[i].second != along[i - 1].second);
}

TEST_CASE("Crossings are those that every pair of edges would show") {
  std::mt19937 random(11);
  std::uniform_real_distribution<double> uniform(-1, 1);
  std::vector<Polyline> lines;
  for (int i = 0; i < 60; ++i) {
    const auto point = [&] {
      return Eigen::Vector3d(uniform(random), uniform(random), uniform(random));
    };
    const Eigen::Vector3d from = point();
    lines.push_back(segment(from, point()));
  }
  std::size_t expected = 0;
  for (std::size_t i = 0; i < lines.size(); ++i)
    for (std::size_t j = 0; j < i; ++j)
      expected +=
          fabricate::crossings(std::vector{lines[i], lines[j]}, Eigen::Matrix3d::Identity()).size();
  const auto found = fabricate::crossings(lines, Eigen::Matrix3d::Identity());
  CHECK(expected > 100);
  CHECK(found.size() == expected);
  for (const auto& c : found) {
    const auto at = [&](const geometry::EdgePoint& p) {
      const auto& x = lines[p.rod].points;
      return Eigen::Vector3d((1 - p.t) * x.col(0) + p.t * x.col(1));
    };
    const Eigen::Vector3d between = at(c.over) - at(c.under);
    CHECK(between.head<2>().norm() == Approx(0).margin(1e-12));
    CHECK(between.z() == Approx(c.height));
  }
}
