#include <Eigen/Geometry>
#include <limits>
#include <tencer/geometry/hull.hpp>

namespace tencer::geometry {
namespace {

double diagonal(const Eigen::Matrix3Xd& points) {
  return points.cols() == 0 ? 0.0
                            : (points.rowwise().maxCoeff() - points.rowwise().minCoeff()).norm();
}

// Takes the plane through `at` with this normal as a face when all corners lie on one side of it,
// and keeps the point furthest beyond. Returns whether it is a face with the hull's inside behind
// it.
bool try_face(const Eigen::Matrix3Xd& corners, const Eigen::Matrix3Xd& points,
              const Eigen::Vector3d& at, Eigen::Vector3d normal, double tolerance, Outside& worst) {
  Eigen::RowVectorXd heights = normal.transpose() * (corners.colwise() - at);
  if (heights.maxCoeff() > tolerance) {
    heights = -heights;
    normal = -normal;
  }
  if (heights.maxCoeff() > tolerance || heights.minCoeff() >= -tolerance) return false;
  Eigen::Index furthest = 0;
  const double beyond = (normal.transpose() * (points.colwise() - at)).maxCoeff(&furthest);
  if (beyond > tolerance && beyond > worst.distance) worst = {static_cast<int>(furthest), beyond};
  return true;
}

}  // namespace

Outside outside_hull(const Eigen::Matrix3Xd& corners, const Eigen::Matrix3Xd& points, bool planar) {
  const double size = diagonal(corners);
  const double tolerance = 1e-9 * size;
  Outside worst;
  bool solid = false;
  for (Eigen::Index i = 0; i < corners.cols(); ++i)
    for (Eigen::Index j = 0; j < i; ++j) {
      const Eigen::Vector3d edge = corners.col(i) - corners.col(j);
      if (edge.norm() <= tolerance) continue;
      const auto face = [&](const Eigen::Vector3d& across) {
        const Eigen::Vector3d normal = edge.cross(across);
        if (normal.norm() > 1e-9 * edge.norm() * across.norm())
          solid |= try_face(corners, points, corners.col(j), normal.normalized(), tolerance, worst);
      };
      if (planar) {
        face(Eigen::Vector3d::UnitZ());
      } else {
        for (Eigen::Index k = 0; k < j; ++k) face(corners.col(k) - corners.col(j));
      }
    }
  if (!solid) return {0, std::numeric_limits<double>::infinity()};
  return worst;
}

}  // namespace tencer::geometry
