#include "remainder.hpp"

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

namespace tencer::lower_bound {
namespace {

using Eigen::Index;

// Of several functions with a vector at every vertex (3 n x k): per vertex, the longest vector that
// a unit sum of them has there.
Eigen::VectorXd sizes(const Eigen::MatrixXd& functions) {
  Eigen::VectorXd result(functions.rows() / 3);
  for (Index i = 0; i < result.size(); ++i) {
    const auto rows = functions.middleRows<3>(3 * i);
    const Eigen::Matrix3d square = rows * rows.transpose();
    const double largest = functions.cols() == 1 ? square.trace()
                                                 : Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(
                                                       square, Eigen::EigenvaluesOnly)
                                                       .eigenvalues()[2];
    result[i] = std::sqrt(std::max(0.0, largest));
  }
  return result;
}

// |M_i| of the target's points.
Eigen::VectorXd moments(const WeakForm& form, const Parameters& p) {
  const Eigen::Vector3d A = p.head<3>(), F = p.tail<3>();
  Eigen::VectorXd result(form.vertices());
  for (Index i = 0; i < result.size(); ++i) result[i] = (A + F.cross(form.y.col(i))).norm();
  return result;
}

// Per vertex, |l_i - l_(i-1)|; 0 at the ends.
Eigen::VectorXd unevenness(const WeakForm& form) {
  Eigen::VectorXd uneven = Eigen::VectorXd::Zero(form.vertices());
  for (Index i = 1; i + 1 < uneven.size(); ++i) uneven[i] = std::abs(form.l[i] - form.l[i - 1]);
  return uneven;
}

// |v c m - (x_(i+1) - x_(i-1)) / 2| is no larger.
Eigen::VectorXd arm_error(const WeakForm& form, const Pose& pose) {
  return form.v.array() * (pose.bend.array().square() / 4 + pose.stretch) +
         unevenness(form).array() * pose.bend.array() / 4;
}

// Per edge, |delta_(j+1) - delta_j| / l_j is no larger: displacements end within the error, and
// their slope varies by `change` from edge to edge, at most.
Eigen::VectorXd slopes(const WeakForm& form, const Eigen::VectorXd& change) {
  const Index edges = form.l.size();
  Eigen::VectorXd until(edges);  // the change from edge 0 to this one, summed
  until[0] = 0;
  for (Index j = 1; j < edges; ++j) until[j] = until[j - 1] + change[j];
  Eigen::VectorXd best(edges);
  for (Index j = 0; j < edges; ++j) {
    double length = form.l[j];
    double varied = 0;
    best[j] = 2 * form.error / length;
    for (Index reach = 1; reach < edges; ++reach) {
      for (const Index k : {j - reach, j + reach}) {
        if (k < 0 || k >= edges) continue;
        length += form.l[k];
        varied += form.l[k] * std::abs(until[k] - until[j]);
      }
      best[j] = std::min(best[j], (2 * form.error + varied) / length);
    }
  }
  return best;
}

}  // namespace

Pose any_pose(const WeakForm& form) {
  Pose pose{.bend = Eigen::VectorXd::Constant(form.vertices(), form.most_bend),
            .drift = Eigen::VectorXd::Zero(form.vertices()),
            .stretch = most_stretch};
  for (Index i = 1; i + 1 < form.vertices(); ++i)
    pose.drift[i] = std::min(form.error, form.v[i] * (1 + most_stretch) + form.along.col(i).norm());
  return pose;
}

Pose pose_within(const WeakForm& form, const Range& range) {
  Pose pose = any_pose(form);
  const double force = range.centre.tail<3>().norm() + range.F_radius;
  const Eigen::VectorXd moment = moments(form, range.centre).array() + range.A_radius +
                                 force * form.error +
                                 range.F_radius * form.y.colwise().norm().transpose().array();
  pose.bend = pose.bend.cwiseMin(form.v.cwiseProduct(moment));
  pose.stretch = std::min(pose.stretch, force / form.slenderness);
  Eigen::VectorXd change = Eigen::VectorXd::Zero(form.l.size());
  for (Index i = 1; i + 1 < form.vertices(); ++i) {
    const Eigen::Vector3d before = (form.y.col(i) - form.y.col(i - 1)) / form.l[i - 1];
    const Eigen::Vector3d after = (form.y.col(i + 1) - form.y.col(i)) / form.l[i];
    change[i] = pose.bend[i] + 2 * pose.stretch + (after - before).norm();
  }
  const Eigen::VectorXd slope = slopes(form, change);
  for (Index i = 1; i + 1 < form.vertices(); ++i)
    pose.drift[i] =
        std::min(pose.drift[i], (form.l[i - 1] * slope[i - 1] + form.l[i] * slope[i]) / 2);
  return pose;
}

Remainder remainder(const WeakForm& form, const Pose& pose, const Parameters& centre,
                    const Eigen::MatrixXd& z) {
  const Eigen::MatrixXd psi = form.psi * z;
  const Eigen::VectorXd size = sizes(psi);
  const Eigen::VectorXd arm = size.cwiseProduct(arm_error(form, pose));
  const Eigen::MatrixXd step = psi.bottomRows(psi.rows() - 3) - psi.topRows(psi.rows() - 3);
  // Per unit of force: edges that are not as long as at rest, displacements times displacements,
  // and the moment where the vertex is in place of where it should be.
  const double per_force =
      sizes(step).sum() / form.slenderness + form.error * (size.dot(pose.drift) + arm.sum());
  Eigen::MatrixXd per(form.vertices(), 6);
  for (int k = 0; k < 6; ++k) per.col(k) = sizes(form.g_per[k] * z);
  return {.fixed = form.error * sizes(form.g(centre) * z).sum() +
                   per_force * centre.tail<3>().norm() + arm.dot(moments(form, centre)),
          .per_A = form.error * per.leftCols<3>().rowwise().norm().sum() + arm.sum(),
          .per_F = form.error * per.rightCols<3>().rowwise().norm().sum() + per_force +
                   arm.dot(form.y.colwise().norm().transpose())};
}

Eigen::VectorXd cost_of_size(const WeakForm& form, const Pose& pose, const Parameters& centre) {
  const double force = centre.tail<3>().norm();
  return form.error * force * pose.drift +
         arm_error(form, pose)
             .cwiseProduct((moments(form, centre).array() + form.error * force).matrix());
}

}  // namespace tencer::lower_bound
