#include <tencer/core/error.hpp>
#include <tencer/springs/law.hpp>

namespace tencer::springs {

double tension(const Cable& cable, double length) {
  if (cable.tension_only && length < cable.rest_length) return 0.0;
  return cable.stiffness * (length - cable.rest_length);
}

double energy(const Cable& cable, double length) {
  return tension(cable, length) * (length - cable.rest_length) / 2;
}

Eigen::Vector3d force(const Cable& cable, const Eigen::Vector3d& d) {
  const double length = d.norm();
  if (cable.rest_length == 0.0) return cable.stiffness * d;
  if (length == 0.0) return Eigen::Vector3d::Zero();
  return tension(cable, length) / length * d;
}

Eigen::Matrix3d stiffness_matrix(const Cable& cable, const Eigen::Vector3d& d, double tension) {
  const double length = d.norm();
  if (cable.rest_length == 0.0) return cable.stiffness * Eigen::Matrix3d::Identity();
  if (length == 0.0 || (cable.tension_only && length < cable.rest_length))
    return Eigen::Matrix3d::Zero();
  const double density = tension / length;
  return density * Eigen::Matrix3d::Identity() +
         (cable.stiffness - density) / (length * length) * d * d.transpose();
}

Cable rebased(const Cable& cable, double length, double rest_ratio) {
  return with_tension(cable, length, tension(cable, length), rest_ratio);
}

Cable with_tension(Cable cable, double length, double tension, double rest_ratio) {
  core::require(length > 0 && rest_ratio >= 0 && rest_ratio < 1,
                "with_tension: needs length > 0 and 0 <= rest_ratio < 1");
  cable.rest_length = rest_ratio * length;
  cable.stiffness = tension / (length - cable.rest_length);
  return cable;
}

}  // namespace tencer::springs
