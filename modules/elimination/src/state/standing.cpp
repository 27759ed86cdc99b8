#include "state/standing.hpp"

#include <algorithm>
#include <limits>
#include <tencer/certify/draws.hpp>
#include <tencer/certify/tolerance.hpp>
#include <tencer/network/settling.hpp>

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

// Whether errors somewhat larger than those asked for make it fall to another pose.
bool falls(const network::Network& network, const Workmanship& workmanship,
           const std::stop_token& stop) {
  constexpr double larger = 1.5;  // so that few draws tell what many smaller ones would
  constexpr int draws = 10;
  const certify::CableErrors errors = errors_of(workmanship, larger);
  if (errors.length == 0 && errors.attachment == 0) return false;
  const model::Structure structure = built(network);
  const Eigen::VectorXd tensions = cable_tensions(network);
  for (std::uint64_t seed = 1; seed <= draws; ++seed)
    for (const certify::Draw& draw :
         certify::settle_draws(structure, network.state, tensions, errors, 1, seed, stop))
      if (!draw.rests || draw.falls_at || !draw.followed) return true;
  return false;
}

}  // namespace

double error_deviation(const network::Network& network, const Workmanship& workmanship) {
  constexpr int draws = 500;
  const Eigen::VectorXd tensions = cable_tensions(network);
  const auto response = certify::pose_response(built(network), network.state, tensions);
  if (!response.computed) return std::numeric_limits<double>::infinity();
  return certify::tolerance(response, tensions, errors_of(workmanship), draws).percentile_95;
}

Standing standing_of(const network::Network& network, const Requirements& requirements,
                     const Workmanship& workmanship, const std::stop_token& stop) {
  Standing standing{.settles = settles_from_target(network, requirements.target, stop),
                    .clear = is_clear(network, requirements),
                    .deviation = error_deviation(network, workmanship)};
  // Draws take longer than all else.
  standing.forgives = standing.settles && standing.clear &&
                      standing.deviation <= workmanship.max_deviation &&
                      !falls(network, workmanship, stop);
  return standing;
}

}  // namespace tencer::elimination
