#include <Eigen/Geometry>
#include <Eigen/LU>
#include <Eigen/SVD>
#include <cmath>
#include <tencer/core/error.hpp>
#include <tencer/registration/rigid.hpp>

namespace tencer::registration {
namespace {

// Relative size below which a spread or a singular value is rounding: the covariance of n points
// carries about eps sqrt(n), and a thousand points are common.
constexpr double rounding = 1e-13;
// The same for what lies across the leading direction.
constexpr double across_rounding = 1e-14;

// A right-handed frame of the unit vector u and what is left of n across it.
Eigen::Matrix3d frame(const Eigen::Vector3d& u, const Eigen::Vector3d& n) {
  Eigen::Matrix3d result;
  result.col(0) = u;
  result.col(1) = (n - n.dot(u) * u).normalized();
  result.col(2) = u.cross(result.col(1));
  return result;
}

// The smallest rotation that takes the unit vector u to v, accurate also for opposite vectors,
// where the usual quaternion formula loses half its digits.
Eigen::Matrix3d smallest_rotation(const Eigen::Vector3d& u, const Eigen::Vector3d& v) {
  const Eigen::Vector3d cross = u.cross(v);
  const Eigen::Vector3d axis =
      cross.norm() > 1e-8 ? cross.normalized() : Eigen::Vector3d(u.unitOrthogonal());
  return frame(v, axis) * frame(u, axis).transpose();
}

// a, b: 3 x n, centred. What rounding leaves of their covariance is about epsilon times size, and
// of the part across a direction, a product of two such remainders, epsilon^2 times far.
Eigen::Matrix3d best_rotation(const Eigen::Matrix3Xd& a, const Eigen::Matrix3Xd& b,
                              const Eigen::VectorXd& weights, double size, double far) {
  const Eigen::Matrix3d covariance = a * weights.asDiagonal() * b.transpose();
  const Eigen::JacobiSVD<Eigen::Matrix3d> svd(covariance,
                                              Eigen::ComputeFullU | Eigen::ComputeFullV);
  if (svd.singularValues()[0] <= rounding * size) return Eigen::Matrix3d::Identity();
  // The best rotation takes the leading direction of a to that of b. The turn about it is found
  // from what lies across it: in the covariance, which has its square, that would be lost for
  // nearly straight sets.
  const Eigen::Vector3d v = svd.matrixV().col(0);
  const Eigen::Matrix3d first = smallest_rotation(svd.matrixU().col(0), v);
  const Eigen::Matrix3d axes = frame(v, v.unitOrthogonal());
  const Eigen::Matrix2Xd across_a = (axes.transpose() * first * a).bottomRows<2>();
  const Eigen::Matrix2Xd across_b = (axes.transpose() * b).bottomRows<2>();
  const Eigen::Matrix2d c = across_a * weights.asDiagonal() * across_b.transpose();
  const double cosine = c(0, 0) + c(1, 1);
  const double sine = c(0, 1) - c(1, 0);
  // One direction only: any turn about it is as good, so none is made.
  if (std::hypot(cosine, sine) <= across_rounding * across_rounding * far) return first;
  return Eigen::AngleAxisd(std::atan2(sine, cosine), v).toRotationMatrix() * first;
}

}  // namespace

RigidMotion align(const Eigen::Matrix3Xd& from, const Eigen::Matrix3Xd& to,
                  const Eigen::VectorXd& weights) {
  core::require(from.cols() == to.cols() && from.cols() == weights.size() && from.cols() > 0,
                "align: needs equally many points and weights");
  core::require(weights.minCoeff() >= 0 && weights.sum() > 0,
                "align: needs nonnegative weights, not all zero");
  const Eigen::Vector3d from_centre = from * weights / weights.sum();
  const Eigen::Vector3d to_centre = to * weights / weights.sum();
  const Eigen::Matrix3Xd a = from.colwise() - from_centre;
  const Eigen::Matrix3Xd b = to.colwise() - to_centre;
  // What rounding leaves of coincident points far from the origin must not pass for a direction, so
  // the distance to the origin enters each set's size.
  const Eigen::VectorXd root = weights.cwiseSqrt();
  const double size = (from * root.asDiagonal()).norm() * (b * root.asDiagonal()).norm() +
                      (a * root.asDiagonal()).norm() * (to * root.asDiagonal()).norm();
  const double far = (from * root.asDiagonal()).norm() * (to * root.asDiagonal()).norm();
  RigidMotion motion;
  motion.rotation = best_rotation(a, b, weights, size, far);
  motion.translation = to_centre - motion.rotation * from_centre;
  return motion;
}

RigidMotion align_in_plane(const Eigen::Matrix3Xd& from, const Eigen::Matrix3Xd& to,
                           const Eigen::VectorXd& weights) {
  core::require(from.cols() == to.cols() && from.cols() == weights.size() && from.cols() > 0,
                "align_in_plane: needs as many points and weights on either side");
  Eigen::Vector3d from_centre = from * weights / weights.sum();
  Eigen::Vector3d to_centre = to * weights / weights.sum();
  from_centre.z() = to_centre.z() = 0;
  double cosine = 0;
  double sine = 0;
  for (Eigen::Index i = 0; i < to.cols(); ++i) {
    const Eigen::Vector3d a = to.col(i) - to_centre;
    const Eigen::Vector3d b = from.col(i) - from_centre;
    cosine += weights[i] * (a.x() * b.x() + a.y() * b.y());
    sine += weights[i] * (b.x() * a.y() - b.y() * a.x());
  }
  const double norm = std::hypot(cosine, sine);
  RigidMotion motion;
  if (norm > 0) {
    motion.rotation.topLeftCorner<2, 2>() << cosine, -sine, sine, cosine;
    motion.rotation.topLeftCorner<2, 2>() /= norm;
  }
  motion.translation = to_centre - motion.rotation * from_centre;
  return motion;
}

std::array<OrthogonalFit, 2> orthogonal_fits(const Eigen::Matrix3Xd& from,
                                             const Eigen::Matrix3Xd& to) {
  core::require(from.cols() == to.cols(), "orthogonal_fits: needs as many points on either side");
  const Eigen::Matrix3d product = to * from.transpose();
  const Eigen::JacobiSVD<Eigen::Matrix3d> svd(product, Eigen::ComputeFullU | Eigen::ComputeFullV);
  const Eigen::Matrix3d straight = svd.matrixU() * svd.matrixV().transpose();
  const Eigen::Matrix3d flipped =
      svd.matrixU() * Eigen::Vector3d(1, 1, -1).asDiagonal() * svd.matrixV().transpose();
  const bool proper = straight.determinant() > 0.0;
  std::array<OrthogonalFit, 2> fits{OrthogonalFit{.matrix = proper ? straight : flipped},
                                    OrthogonalFit{.matrix = proper ? flipped : straight}};
  for (OrthogonalFit& fit : fits) fit.squares = (fit.matrix * from - to).squaredNorm();
  return fits;
}

}  // namespace tencer::registration
