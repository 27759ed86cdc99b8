// How few cables could do for a scene that was prepared.
#pragma once

#include <stop_token>
#include <tencer/model/at_least.hpp>
#include <tencer/pipeline/prepare.hpp>

namespace tencer::pipeline {

// lower_bound::at_least of the prepared problem, in the scene's units.
model::AtLeast at_least(const Prepared& prepared, double error_percent,
                        const std::stop_token& stop);

}  // namespace tencer::pipeline
