// The optimizers that are part of the build.
#pragma once

#include <tencer/optimize/gauss_newton.hpp>
#include <tencer/sparsify/outer.hpp>
#include <vector>
#ifdef TENCER_WITH_OPTIMIZE_IPOPT
#include <tencer/optimize_ipopt/backends.hpp>
#endif
#ifdef TENCER_WITH_OPTIMIZE_NLOPT
#include <tencer/optimize_nlopt/backends.hpp>
#endif

namespace tencer::fixtures {

inline std::vector<optimize::Backend> backends() {
  std::vector<optimize::Backend> all{optimize::gauss_newton()};
#ifdef TENCER_WITH_OPTIMIZE_IPOPT
  for (auto& backend : optimize_ipopt::backends()) all.push_back(backend);
#endif
#ifdef TENCER_WITH_OPTIMIZE_NLOPT
  for (auto& backend : optimize_nlopt::backends()) all.push_back(backend);
#endif
  return all;
}

// Enough for what the tests ask.
inline sparsify::OuterOptions quick() {
  return {.rounds = 3, .iterations = 30, .iterations_without = 60};
}

}  // namespace tencer::fixtures
