// Registration of targets that are straight, planar, coincident or far away.
#include <Eigen/Geometry>
#include <cmath>
#include <numbers>
#include <string>
#include <tencer/registration/rigid.hpp>

#include "groups.hpp"

namespace tencer::app::stress {
namespace {

constexpr int points = 200;

Eigen::Matrix3Xd straight() {
  Eigen::Matrix3Xd x = Eigen::Matrix3Xd::Zero(3, points);
  x.row(0).setLinSpaced(0, 1);
  return x;
}

Eigen::Matrix3Xd planar() {
  Eigen::Matrix3Xd x = straight();
  for (int i = 0; i < points; ++i) x(1, i) = 0.3 * std::sin(5 * x(0, i));
  return x;
}

// Straight but for a bow of that height.
Eigen::Matrix3Xd nearly_straight(double height) {
  Eigen::Matrix3Xd x = straight();
  for (int i = 0; i < points; ++i) x(1, i) = height * x(0, i) * (1 - x(0, i));
  return x;
}

Row aligned(std::string name, const Eigen::Matrix3Xd& from, double turn, double away) {
  const Eigen::Matrix3d rotation =
      Eigen::AngleAxisd(turn, Eigen::Vector3d(1, -2, 3).normalized()).toRotationMatrix();
  const Eigen::Matrix3Xd to = (rotation * from).colwise() + away * Eigen::Vector3d(0.6, -0.4, 0.7);
  const auto motion = registration::align(from, to, Eigen::VectorXd::Ones(points));
  const Eigen::Matrix3Xd found = motion.apply(from);
  const double size = std::max(1.0, away);
  const double improper =
      (motion.rotation.transpose() * motion.rotation - Eigen::Matrix3d::Identity()).norm() +
      std::abs(motion.rotation.determinant() - 1);
  return {.name = std::move(name),
          .known = "the motion that was applied",
          .promise = 1e-13,
          .error = std::max((found - to).colwise().norm().maxCoeff() / size, improper),
          .claims_answer = true,
          .finite = found.allFinite() && motion.rotation.allFinite(),
          .report = "aligned"};
}

// A set and its mirror image: the best proper rotation leaves it as it is.
Row mirrored() {
  const Eigen::Matrix3Xd from = planar();
  Eigen::Matrix3Xd to = from;
  to.row(2) = -to.row(2);
  const auto motion = registration::align(from, to, Eigen::VectorXd::Ones(points));
  return {.name = "planar, mirrored in its plane",
          .known = "no motion",
          .promise = 1e-13,
          .error = (motion.rotation - Eigen::Matrix3d::Identity()).norm(),
          .claims_answer = true,
          .finite = motion.rotation.allFinite(),
          .report = "aligned"};
}

}  // namespace

Group alignments() {
  Group group{.title = "Registration"};
  group.rows = {aligned("straight (collinear)", straight(), 2.0, 1.0),
                aligned("straight, turned by half a turn", straight(), std::numbers::pi, 1.0),
                aligned("straight but for a bow of 1e-9", nearly_straight(1e-9), 2.0, 1.0),
                aligned("straight but for a bow of 1e-13", nearly_straight(1e-13), 2.0, 1.0),
                aligned("planar", planar(), 2.0, 1.0),
                aligned("planar, turned by half a turn", planar(), std::numbers::pi, 1.0),
                mirrored(),
                aligned("all points the same", Eigen::Matrix3Xd::Zero(3, points), 2.0, 1.0),
                aligned("planar, 1e6 sizes away", planar(), 2.0, 1e6),
                aligned("straight, 1e6 sizes away", straight(), 2.0, 1e6),
                aligned("planar, 1e-9 in size, 1 away", 1e-9 * planar(), 2.0, 1.0)};
  return group;
}

}  // namespace tencer::app::stress
