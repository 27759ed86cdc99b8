#include "model/soft_rates.hpp"

#include <tencer/sensitivity/parameters.hpp>

namespace tencer::elimination {

Eigen::VectorXd soft_rates(const sensitivity::Configuration& at, const equilibrium::SoftModes& soft,
                           Eigen::Index k, const LocalModel& local) {
  const Eigen::VectorXd mode = soft.modes.col(k);
  const auto curvature = sensitivity::force_curvature(at.system, at.state, local.parameters, mode);
  const Eigen::VectorXd third =
      sensitivity::third_derivative_times(at.system, at.state, mode, mode);
  return (local.ties.transpose() * (curvature.mixed.transpose() * mode) +
          local.motion.transpose() * third) /
         equilibrium::eigenvalue_unit(at.system.structure());
}

}  // namespace tencer::elimination
