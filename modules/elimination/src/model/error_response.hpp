// How far small errors of its cables move a network, by its softest motions.
#pragma once

#include <Eigen/Core>
#include <tencer/certify/tolerance.hpp>
#include <tencer/elimination/options.hpp>
#include <tencer/equilibrium/modal.hpp>
#include <tencer/sensitivity/tracker.hpp>

namespace tencer::elimination {

// The workmanship's errors, so many times as large.
certify::CableErrors errors_of(const Workmanship& workmanship, double times = 1);

struct ErrorResponse {
  // Of the modes' coordinates (modes x modes): squares of mean displacements.
  Eigen::MatrixXd covariance{};
  double deviation = 0.0;  // standard deviation of the vertex that is seen to move most, a length
};

// Errors are independent and uniform within the limits of the workmanship; the first cables, as
// many as `fixed_cables`, have none. What stiffer modes add is left out. metric: of what is seen of
// a motion, in the frame of the state (model::seen_metric).
ErrorResponse error_response(const sensitivity::Configuration& at,
                             const equilibrium::SoftModes& soft, const Workmanship& workmanship,
                             int fixed_cables, const Eigen::Matrix3d& metric);

}  // namespace tencer::elimination
