// Finds out whether a network stands once it is built.
#pragma once

#include <stop_token>
#include <tencer/elimination/solution.hpp>

#include "state/fitted_network.hpp"

namespace tencer::elimination {

// workmanship: what is asked, where the requirements may ask for less.
Standing standing_of(const network::Network& network, const Requirements& requirements,
                     const Workmanship& workmanship, const std::stop_token& stop);

// The deviation by these errors; infinite where there is no first order.
double error_deviation(const network::Network& network, const Workmanship& workmanship);

}  // namespace tencer::elimination
