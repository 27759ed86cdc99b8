#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>
#include <tencer/curves/braid.hpp>
#include <vector>

using namespace tencer;
using namespace tencer::curves;
using geometry::Polyline;
using std::numbers::pi;

TEST_CASE("a braid closure goes round once a strand") {
  const Polyline curve = braid_closure(3, std::vector<int>{1, 2});
  double turns = 0;
  for (int i = 0; i < curve.vertices(); ++i) {
    const Eigen::Vector3d a = curve.points.col(i), b = curve.points.col((i + 1) % curve.vertices());
    turns += std::atan2(a.x() * b.y() - a.y() * b.x(), a.x() * b.x() + a.y() * b.y()) / (2 * pi);
  }
  CHECK(turns == Approx(3));
  const auto closed = [](int strands, std::vector<int> word) { braid_closure(strands, word); };
  CHECK_THROWS_AS(closed(2, {1, 1}), std::invalid_argument);  // two curves
  CHECK_THROWS_AS(closed(3, {1, 3}), std::invalid_argument);
  CHECK_THROWS_AS(closed(3, {0, 1}), std::invalid_argument);
  CHECK_THROWS_AS(closed(1, {}), std::invalid_argument);
}
