#include <tencer/optimize/gauss_newton.hpp>
#include <tencer/pipeline/backends.hpp>

#ifdef TENCER_WITH_OPTIMIZE_IPOPT
#include <tencer/optimize_ipopt/backends.hpp>
#endif
#ifdef TENCER_WITH_OPTIMIZE_NLOPT
#include <tencer/optimize_nlopt/backends.hpp>
#endif

namespace tencer::pipeline {

std::vector<optimize::Backend> backends() {
  std::vector<optimize::Backend> all{optimize::gauss_newton()};
#ifdef TENCER_WITH_OPTIMIZE_IPOPT
  for (auto& backend : optimize_ipopt::backends()) all.push_back(std::move(backend));
#endif
#ifdef TENCER_WITH_OPTIMIZE_NLOPT
  for (auto& backend : optimize_nlopt::backends()) all.push_back(std::move(backend));
#endif
  return all;
}

}  // namespace tencer::pipeline
