#include "state/standing.hpp"

#include <algorithm>
#include <limits>
#include <tencer/certify/draws.hpp>
#include <tencer/certify/tolerance.hpp>
#include <tencer/network/settling.hpp>
#include <tencer/sensitivity/distance.hpp>

#include "model/gap_bounds.hpp"

namespace tencer::elimination {
namespace {

bool settles_from_target(const network::Network& network, const model::Target& target,
                         const std::stop_token& stop) {
  return settle(network, make_state(network.structure, target.points), target, {.stop = stop})
      .in_pose();
}

// Gaps within a little of what is asked, tensions likewise.
bool is_clear(const network::Network& network, const Requirements& requirements) {
  constexpr double near = 0.05;  // of a rod's radius, and of a tension
  const auto& gaps = requirements.rules.gaps;
  if (gaps && missing_gap(network.structure, network.state, *gaps) > near) return false;
  const Eigen::VectorXd tensions = cable_tensions(network);
  return tensions.size() == 0 ||
         tensions.minCoeff() >=
             (1 - near) * requirements.workmanship.least_tension(tensions.maxCoeff());
}

}  // namespace

double error_deviation(const network::Network& network, const model::Target& target,
                       const Workmanship& workmanship) {
  constexpr int draws = 2000;  // as many as a check of the design makes
  const Eigen::VectorXd tensions = cable_tensions(network);
  const auto response = certify::pose_response(built(network), network.state, tensions,
                                               sensitivity::views_at(target, network.state));
  if (!response.computed) return std::numeric_limits<double>::infinity();
  return certify::tolerance(response, tensions, errors_of(workmanship), draws).percentile_95;
}

bool keeps_its_pose(const network::Network& network, const Requirements& requirements,
                    const std::stop_token& stop) {
  constexpr double larger = 1.5;  // so that few draws tell what many smaller ones would
  constexpr int draws = 10;
  if (!settles_from_target(network, requirements.target, stop)) return false;
  const certify::CableErrors errors = errors_of(requirements.workmanship, larger);
  if (errors.length == 0 && errors.attachment == 0) return true;
  return certify::all_keep_their_paths(built(network), network.state, cable_tensions(network),
                                       errors, draws, 1, stop);
}

Standing standing_of(const network::Network& network, const Requirements& requirements,
                     const std::stop_token& stop) {
  // A check of the design draws other errors, and on other vertices.
  constexpr double spare = 0.97;
  Standing standing{.deviation =
                        error_deviation(network, requirements.target, requirements.workmanship)};
  if (standing.deviation <= spare * requirements.standing_deviation &&
      is_clear(network, requirements) && keeps_its_pose(network, requirements, stop))
    standing.footing = model::Footing::stands;
  return standing;
}

}  // namespace tencer::elimination
