// The outer optimizers of this build.
#pragma once

#include <tencer/optimize/backend.hpp>
#include <vector>

namespace tencer::pipeline {

// gauss-newton, then every adapter that was not left out when tencer was built; see
// optimize::find_backend.
std::vector<optimize::Backend> backends();

}  // namespace tencer::pipeline
