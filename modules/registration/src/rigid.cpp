#include <tencer/core/error.hpp>
#include <tencer/registration/rigid.hpp>

#include <Eigen/SVD>

namespace tencer::registration {

RigidMotion align(const Eigen::Matrix3Xd& from, const Eigen::Matrix3Xd& to,
                  const Eigen::VectorXd& weights) {
  core::require(from.cols() == to.cols() && from.cols() == weights.size() && from.cols() > 0,
                "align: needs equally many points and weights");
  core::require(weights.minCoeff() >= 0 && weights.sum() > 0,
                "align: needs nonnegative weights, not all zero");
  const Eigen::Vector3d from_centre = from * weights / weights.sum();
  const Eigen::Vector3d to_centre = to * weights / weights.sum();
  const Eigen::Matrix3d covariance = (from.colwise() - from_centre) * weights.asDiagonal() *
                                     (to.colwise() - to_centre).transpose();
  const Eigen::JacobiSVD<Eigen::Matrix3d> svd(covariance, Eigen::ComputeFullU | Eigen::ComputeFullV);
  Eigen::Vector3d signs = Eigen::Vector3d::Ones();
  signs[2] = (svd.matrixV() * svd.matrixU().transpose()).determinant() < 0 ? -1.0 : 1.0;
  RigidMotion motion;
  motion.rotation = svd.matrixV() * signs.asDiagonal() * svd.matrixU().transpose();
  motion.translation = to_centre - motion.rotation * from_centre;
  return motion;
}

}  // namespace tencer::registration
