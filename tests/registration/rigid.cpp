#include <Eigen/Geometry>
#include <catch2/catch.hpp>
#include <numbers>
#include <random>
#include <tencer/registration/rigid.hpp>

using tencer::registration::align;
using tencer::registration::RigidMotion;

namespace {

double normal(std::mt19937& random) { return std::normal_distribution<double>()(random); }

Eigen::Matrix3Xd random_points(std::mt19937& random, int n) {
  return Eigen::Matrix3Xd::NullaryExpr(3, n, [&] { return normal(random); });
}

RigidMotion random_motion(std::mt19937& random) {
  const Eigen::Quaterniond turn(normal(random), normal(random), normal(random), normal(random));
  return {turn.normalized().toRotationMatrix(), 10 * random_points(random, 1)};
}

Eigen::VectorXd random_weights(std::mt19937& random, int n) {
  std::uniform_real_distribution<double> uniform(0.1, 2.0);
  return Eigen::VectorXd::NullaryExpr(n, [&] { return uniform(random); });
}

double cost(const RigidMotion& motion, const Eigen::Matrix3Xd& from, const Eigen::Matrix3Xd& to,
            const Eigen::VectorXd& weights) {
  return (motion.apply(from) - to).colwise().squaredNorm() * weights;
}

void check_proper(const RigidMotion& motion) {
  REQUIRE(motion.rotation.allFinite());
  REQUIRE(motion.translation.allFinite());
  CHECK((motion.rotation.transpose() * motion.rotation - Eigen::Matrix3d::Identity()).norm() <
        1e-14);
  CHECK(motion.rotation.determinant() == Approx(1.0).epsilon(1e-14));
}

double angle(const RigidMotion& motion) { return Eigen::AngleAxisd(motion.rotation).angle(); }

}  // namespace

TEST_CASE("recovers a rigid motion") {
  std::mt19937 random(7);
  for (int trial = 0; trial < 200; ++trial) {
    const int n = 3 + trial;
    const Eigen::Matrix3Xd from = random_points(random, n);
    const RigidMotion truth = random_motion(random);
    const RigidMotion found = align(from, truth.apply(from), random_weights(random, n));
    check_proper(found);
    REQUIRE((found.rotation - truth.rotation).norm() < 1e-12);
    REQUIRE((found.translation - truth.translation).norm() < 1e-12 * 20);
  }
}

TEST_CASE("recovers a rigid motion of planar points") {
  std::mt19937 random(8);
  for (int trial = 0; trial < 100; ++trial) {
    Eigen::Matrix3Xd from = random_points(random, 20);
    from.row(2).setZero();
    from = random_motion(random).apply(from);
    const RigidMotion truth = random_motion(random);
    const RigidMotion found = align(from, truth.apply(from), Eigen::VectorXd::Ones(20));
    check_proper(found);
    REQUIRE((found.rotation - truth.rotation).norm() < 1e-12);
  }
}

TEST_CASE("a mirrored set is met by the best rotation, not by a reflection") {
  std::mt19937 random(9);
  for (int trial = 0; trial < 100; ++trial) {
    const Eigen::Matrix3Xd from = random_points(random, 30);
    Eigen::Matrix3Xd to = from;
    to.row(0) *= -1;
    const Eigen::VectorXd weights = random_weights(random, 30);
    const RigidMotion found = align(from, to, weights);
    check_proper(found);
    for (int other = 0; other < 50; ++other) {
      RigidMotion tried = random_motion(random);
      tried.translation = (to - tried.rotation * from) * weights / weights.sum();
      REQUIRE(cost(found, from, to, weights) <= cost(tried, from, to, weights) * (1 + 1e-12));
    }
  }
}

TEST_CASE("no nearby motion costs less") {
  std::mt19937 random(10);
  for (int trial = 0; trial < 50; ++trial) {
    const Eigen::Matrix3Xd from = random_points(random, 15), to = random_points(random, 15);
    const Eigen::VectorXd weights = random_weights(random, 15);
    const RigidMotion found = align(from, to, weights);
    const double least = cost(found, from, to, weights);
    for (const double step : {1e-1, 1e-3}) {
      for (int other = 0; other < 20; ++other) {
        const Eigen::Vector3d axis = random_points(random, 1).normalized();
        RigidMotion near = found;
        near.rotation = Eigen::AngleAxisd(step, axis).toRotationMatrix() * near.rotation;
        near.translation += step * random_points(random, 1);
        REQUIRE(cost(near, from, to, weights) > least);
      }
    }
  }
}

TEST_CASE("turning either set turns the answer with it") {
  std::mt19937 random(11);
  const Eigen::Matrix3Xd from = random_points(random, 12), to = random_points(random, 12);
  const Eigen::VectorXd weights = random_weights(random, 12);
  const RigidMotion found = align(from, to, weights);
  const RigidMotion motion = random_motion(random);
  const RigidMotion moved_to = align(from, motion.apply(to), weights);
  CHECK((moved_to.rotation - motion.rotation * found.rotation).norm() < 1e-12);
  const RigidMotion moved_from = align(motion.apply(from), to, weights);
  CHECK((moved_from.rotation * motion.rotation - found.rotation).norm() < 1e-12);
  const RigidMotion back = align(to, from, weights);
  CHECK((back.rotation - found.rotation.transpose()).norm() < 1e-12);
}

TEST_CASE("a point's weight counts like so many points, and zero like none") {
  std::mt19937 random(12);
  const Eigen::Matrix3Xd from = random_points(random, 6), to = random_points(random, 6);
  Eigen::VectorXd weights = Eigen::VectorXd::Ones(6);
  weights[0] = 3;
  weights[5] = 0;
  Eigen::Matrix3Xd from_repeated(3, 7), to_repeated(3, 7);
  const int repeat[] = {0, 0, 0, 1, 2, 3, 4};
  for (int i = 0; i < 7; ++i) {
    from_repeated.col(i) = from.col(repeat[i]);
    to_repeated.col(i) = to.col(repeat[i]);
  }
  const RigidMotion weighted = align(from, to, weights);
  const RigidMotion repeated = align(from_repeated, to_repeated, Eigen::VectorXd::Ones(7));
  CHECK((weighted.rotation - repeated.rotation).norm() < 1e-13);
  CHECK((weighted.translation - repeated.translation).norm() < 1e-13);
  const RigidMotion scaled = align(from, to, 1e8 * weights);
  CHECK((weighted.rotation - scaled.rotation).norm() < 1e-13);
}

TEST_CASE("collinear points are brought in line by the smallest rotation") {
  std::mt19937 random(13);
  for (const double offset : {0.0, 1.0, 1e6}) {
    for (int trial = 0; trial < 50; ++trial) {
      const Eigen::Vector3d u = random_points(random, 1).normalized();
      const Eigen::Vector3d v = random_points(random, 1).normalized();
      const Eigen::RowVectorXd along = random_points(random, 4).row(0);
      const Eigen::Vector3d start = offset * random_points(random, 1);
      const Eigen::Matrix3Xd from = (u * along).colwise() + start;
      const Eigen::Matrix3Xd to = (v * along).colwise() - start;
      const RigidMotion found = align(from, to, Eigen::VectorXd::Ones(4));
      check_proper(found);
      const double tolerance = 1e-13 * (1 + 100 * offset);
      CHECK((found.rotation * u - v).norm() < tolerance);
      CHECK(angle(found) == Approx(std::acos(u.dot(v))).margin(1e-7 + tolerance));
    }
  }
}

TEST_CASE("the turn about a nearly straight set is found from what little lies across it") {
  std::mt19937 random(15);
  for (const double height : {1e-3, 1e-6, 1e-9}) {
    Eigen::Matrix3Xd from = Eigen::Matrix3Xd::Zero(3, 50);
    from.row(0).setLinSpaced(-1, 1);
    from.row(1) = height * from.row(0).cwiseAbs2();
    const Eigen::Matrix3d turn =
        Eigen::AngleAxisd(2.0, random_points(random, 1).normalized()).toRotationMatrix();
    const Eigen::Matrix3Xd to = turn * from;
    const RigidMotion found = align(from, to, Eigen::VectorXd::Ones(50));
    check_proper(found);
    CHECK((found.apply(from) - to).norm() < 1e-13);
  }
}

TEST_CASE("collinear points onto themselves stay, reversed they make half a turn") {
  Eigen::Matrix3Xd line = Eigen::Matrix3Xd::Zero(3, 5);
  line.row(1) << -2, -1, 0, 1, 2;
  const Eigen::VectorXd weights = Eigen::VectorXd::Ones(5);
  CHECK((align(line, line, weights).rotation - Eigen::Matrix3d::Identity()).norm() < 1e-15);
  const RigidMotion reversed = align(line, -line, weights);
  check_proper(reversed);
  CHECK(angle(reversed) == Approx(std::numbers::pi));
  CHECK((reversed.apply(line) + line).norm() < 1e-14);
}

TEST_CASE("coincident points are moved without a rotation") {
  std::mt19937 random(14);
  for (int trial = 0; trial < 50; ++trial) {
    const int n = 1 + trial % 5;
    const Eigen::Vector3d p = 1000 * random_points(random, 1), q = random_points(random, 1);
    const Eigen::Matrix3Xd from = p.replicate(1, n);
    const Eigen::Matrix3Xd to = trial % 2 ? q.replicate(1, n) : random_points(random, n);
    const RigidMotion found = align(from, to, random_weights(random, n));
    REQUIRE(found.rotation == Eigen::Matrix3d::Identity());
    REQUIRE(found.translation.allFinite());
  }
}

TEST_CASE("mismatched sizes and unusable weights are a caller's mistake") {
  const Eigen::Matrix3Xd three = Eigen::Matrix3Xd::Identity(3, 3);
  CHECK_THROWS_AS(align(three, three.leftCols(2), Eigen::VectorXd::Ones(3)), std::invalid_argument);
  CHECK_THROWS_AS(align(three, three, Eigen::VectorXd::Ones(2)), std::invalid_argument);
  CHECK_THROWS_AS(align(three, three, Eigen::VectorXd::Zero(3)), std::invalid_argument);
  CHECK_THROWS_AS(align(three, three, Eigen::Vector3d(1, -1, 1)), std::invalid_argument);
  CHECK_THROWS_AS(align(Eigen::Matrix3Xd(3, 0), Eigen::Matrix3Xd(3, 0), Eigen::VectorXd()),
                  std::invalid_argument);
}
