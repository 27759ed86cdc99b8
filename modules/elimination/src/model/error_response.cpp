#include "model/error_response.hpp"

#include <algorithm>
#include <cmath>
#include <tencer/sensitivity/parameters.hpp>

#include "model/local_model.hpp"

namespace tencer::elimination {

certify::CableErrors errors_of(const Workmanship& workmanship, double times) {
  return {.length = times * workmanship.length_error,
          .attachment = times * workmanship.attachment_error};
}

ErrorResponse error_response(const sensitivity::Configuration& at,
                             const equilibrium::SoftModes& soft, const Workmanship& workmanship,
                             int fixed_cables, const Eigen::Matrix3d& metric) {
  const Eigen::Index modes = soft.values.size();
  ErrorResponse response{.covariance = Eigen::MatrixXd::Zero(modes, modes)};
  if (!(workmanship.length_error > 0 || workmanship.attachment_error > 0)) return response;
  const auto parameters = cable_parameters(at.cables(), fixed_cables);
  const auto count = static_cast<Eigen::Index>(parameters.size());
  const double unit = equilibrium::eigenvalue_unit(at.system.structure());
  // Mode k's coordinate moves by -(mode . dg/dp) / eigenvalue for a unit of parameter p.
  Eigen::MatrixXd coordinates(count, modes);
  for (Eigen::Index k = 0; k < modes; ++k)
    coordinates.col(k) = sensitivity::force_derivatives_transposed(at.system, at.state, parameters,
                                                                   soft.modes.col(k)) /
                         (soft.values[k] * unit);
  for (Eigen::Index p = 0; p < count; ++p)
    coordinates.row(p) *= certify::limit_of(errors_of(workmanship), parameters[p]) /
                          std::sqrt(3.0);  // the standard deviation of a uniform error
  response.covariance = coordinates.transpose() * coordinates;
  double largest = 0;
  for (int rod = 0; rod < static_cast<int>(at.state.size()); ++rod)
    for (int vertex = 0; vertex < at.state[rod].x.cols(); ++vertex) {
      double variance = 0;
      for (int a = 0; a < 3; ++a)
        for (int b = 0; b < 3; ++b) {
          const int i = at.system.position_index(rod, vertex, a);
          const int j = at.system.position_index(rod, vertex, b);
          if (metric(a, b) != 0 && i >= 0 && j >= 0)
            variance += metric(a, b) * soft.modes.row(i) * response.covariance *
                        soft.modes.row(j).transpose();
        }
      largest = std::max(largest, variance);
    }
  response.deviation = std::sqrt(largest);
  return response;
}

}  // namespace tencer::elimination
