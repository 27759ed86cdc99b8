#include <Eigen/Geometry>
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <limits>
#include <numbers>
#include <tencer/registration/seen.hpp>
#include <vector>

namespace tencer::registration {
namespace {

// A closed curve in space and one a little off it, far more along z.
struct Pair {
  Eigen::Matrix3Xd from{}, to{};
  Eigen::VectorXd weights{};
};

Pair curves(double off, double deeper) {
  constexpr int n = 40;
  Pair pair{.from = Eigen::Matrix3Xd(3, n),
            .to = Eigen::Matrix3Xd(3, n),
            .weights = Eigen::VectorXd::LinSpaced(n, 0.2, 1.5)};
  for (int i = 0; i < n; ++i) {
    const double t = 2 * std::numbers::pi * i / n;
    pair.from.col(i) = Eigen::Vector3d(std::cos(t), 0.6 * std::sin(t) + 0.2 * std::cos(2 * t),
                                       0.3 * std::sin(3 * t + 0.5));
    pair.to.col(i) =
        pair.from.col(i).cwiseProduct(Eigen::Vector3d(1, 1, deeper)) +
        off * Eigen::Vector3d(std::sin(5 * t), std::cos(4 * t + 1), std::sin(2 * t) + t);
  }
  return pair;
}

Eigen::Matrix3d across(const Eigen::Vector3d& direction) {
  const Eigen::Vector3d along = direction.normalized();
  return Eigen::Matrix3d::Identity() - along * along.transpose();
}

// The sum that is made small, in the frame of `from`.
double squares(const RigidMotion& motion, const Pair& pair, const Eigen::Matrix3d& metric) {
  const Eigen::Matrix3Xd away = motion.rotation.transpose() * (pair.to - motion.apply(pair.from));
  return pair.weights.dot(away.cwiseProduct(metric * away).colwise().sum());
}

RigidMotion turned(const Pair& pair, const Eigen::Matrix3d& rotation) {
  const Eigen::Vector3d from = pair.from * pair.weights / pair.weights.sum();
  const Eigen::Vector3d to = pair.to * pair.weights / pair.weights.sum();
  return {rotation, to - rotation * from};
}

const std::vector<Eigen::Matrix3d> metrics{across({0, 0, 1}), across({0.3, -0.5, 1}),
                                           (3 * across({1, 0, 0.2}) + across({0, 1, 1})) / 4};

}  // namespace

TEST_CASE("for the metric 1 the fit is the ordinary one") {
  const Pair pair = curves(0.1, 1.3);
  const RigidMotion plain = align(pair.from, pair.to, pair.weights);
  const RigidMotion seen =
      align_seen(pair.from, pair.to, pair.weights, Eigen::Matrix3d::Identity());
  CHECK((plain.rotation - seen.rotation).norm() < 1e-13);
  CHECK((plain.translation - seen.translation).norm() < 1e-13);
}

TEST_CASE("what moved rigidly, or only along the view, is found") {
  const RigidMotion moved{
      Eigen::AngleAxisd(2.5, Eigen::Vector3d(1, 2, -0.5).normalized()).toRotationMatrix(),
      {3, -4, 0.5}};
  Pair pair = curves(0, 1.6);
  pair.to = moved.apply(pair.to);
  const RigidMotion found = align_seen(pair.from, pair.to, pair.weights, metrics[0]);
  CHECK(squares(found, pair, metrics[0]) < 1e-24);
  CHECK((found.rotation - moved.rotation).norm() < 1e-11);
  // The plain fit is turned by what is not seen.
  const RigidMotion plain = align(pair.from, pair.to, pair.weights);
  CHECK(squares(plain, pair, metrics[0]) > 1e-6);
}

TEST_CASE("no rotation of a fine grid sees less than the fit") {
  for (const auto& metric : metrics)
    for (const double off : {0.02, 0.15}) {
      const Pair pair = curves(off, 1.5);
      const RigidMotion found = align_seen(pair.from, pair.to, pair.weights, metric);
      const double least = squares(found, pair, metric);
      CHECK((found.rotation * found.rotation.transpose()).isIdentity(1e-14));
      CHECK(found.rotation.determinant() > 0);
      double grid = std::numeric_limits<double>::infinity();
      constexpr int steps = 16;
      for (int i = 0; i <= steps; ++i)
        for (int j = 0; j < 2 * steps; ++j)
          for (int k = 0; k < 2 * steps; ++k) {
            const Eigen::Matrix3d rotation =
                (Eigen::AngleAxisd(std::numbers::pi * j / steps, Eigen::Vector3d::UnitZ()) *
                 Eigen::AngleAxisd(std::numbers::pi * i / steps, Eigen::Vector3d::UnitX()) *
                 Eigen::AngleAxisd(std::numbers::pi * k / steps, Eigen::Vector3d::UnitZ()))
                    .toRotationMatrix();
            grid = std::min(grid, squares(turned(pair, rotation), pair, metric));
          }
      CHECK(least <= grid);
      // Nor any nearby, also with other shifts.
      for (int axis = 0; axis < 3; ++axis)
        for (const double h : {-1e-3, 1e-3}) {
          const Eigen::Matrix3d turn =
              Eigen::AngleAxisd(h, Eigen::Vector3d::Unit(axis)).toRotationMatrix();
          CHECK(squares(turned(pair, turn * found.rotation), pair, metric) > least);
          RigidMotion shifted = found;
          shifted.translation += h * Eigen::Vector3d::Unit(axis);
          CHECK(squares(shifted, pair, metric) > least - 1e-12);
        }
    }
}

TEST_CASE("turning what is met turns the fit along") {
  const Pair pair = curves(0.1, 1.4);
  const RigidMotion before = align_seen(pair.from, pair.to, pair.weights, metrics[1]);
  const Eigen::Matrix3d turn =
      Eigen::AngleAxisd(1.9, Eigen::Vector3d(0.2, -1, 0.7).normalized()).toRotationMatrix();
  Pair other = pair;
  other.to = turn * pair.to;
  const RigidMotion after = align_seen(other.from, other.to, other.weights, metrics[1]);
  CHECK((after.rotation - turn * before.rotation).norm() < 1e-12);
  // The views turn with the set that is moved.
  other = pair;
  other.from = turn * pair.from;
  const RigidMotion along =
      align_seen(other.from, other.to, other.weights, turn * metrics[1] * turn.transpose());
  CHECK((along.rotation * turn - before.rotation).norm() < 1e-12);
}

TEST_CASE("a fit that cannot be is refused") {
  const Pair pair = curves(0.1, 1);
  CHECK_THROWS_AS(align_seen(pair.from, pair.to, Eigen::VectorXd::Zero(40), metrics[0]),
                  std::invalid_argument);
  CHECK_THROWS_AS(
      align_seen(pair.from, pair.to, pair.weights, Eigen::Matrix3d::Constant(std::nan(""))),
      std::invalid_argument);
}

}  // namespace tencer::registration
