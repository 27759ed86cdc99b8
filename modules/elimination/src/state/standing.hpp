// Whether a network stands once it is built.
#pragma once

#include <stop_token>

#include "state/fitted_network.hpp"

namespace tencer::elimination {

struct Standing {
  bool settles = false;  // let go at the target it comes to rest in its pose
  bool forgives =
      false;  // errors within the workmanship keep it near its pose; only if the others hold
  bool clear = false;      // gaps and tensions are as asked
  double deviation = 0.0;  // by these errors (95 %), to first order; a length
};

// workmanship: what is asked, where the requirements may ask for less.
Standing standing_of(const network::Network& network, const Requirements& requirements,
                     const Workmanship& workmanship, const std::stop_token& stop);

// The deviation by these errors; infinite where there is no first order.
double error_deviation(const network::Network& network, const Workmanship& workmanship);

}  // namespace tencer::elimination
