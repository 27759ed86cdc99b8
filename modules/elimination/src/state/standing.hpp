// Finds out how a network stands once it is built.
#pragma once

#include <stop_token>
#include <tencer/elimination/solution.hpp>

#include "state/fitted_network.hpp"

namespace tencer::elimination {

// Let go at the target it comes to rest in its pose, and no errors like those of the workmanship
// make it fall: by a few draws. false when stopped.
bool keeps_its_pose(const network::Network& network, const Requirements& requirements,
                    const std::stop_token& stop);

// Whether it stands; Footing::none otherwise.
Standing standing_of(const network::Network& network, const Requirements& requirements,
                     const std::stop_token& stop);

// The deviation by these errors; infinite where there is no first order.
double error_deviation(const network::Network& network, const model::Target& target,
                       const Workmanship& workmanship);

}  // namespace tencer::elimination
