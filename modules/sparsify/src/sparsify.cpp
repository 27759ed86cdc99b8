#include <algorithm>
#include <cmath>
#include <cstdio>
#include <tencer/core/error.hpp>
#include <tencer/sparsify/rest_length.hpp>
#include <tencer/sparsify/sparsify.hpp>

#include "refine.hpp"
#include "stage_clock.hpp"

namespace tencer::sparsify {
namespace {

std::string weight_note(bool external, double weight) {
  char text[64];
  std::snprintf(text, sizeof text, "%s weight %.3g", external ? "external" : "internal", weight);
  return text;
}

}  // namespace

StageResult sparsify(const Network& network, const sensitivity::Target& target,
                     const optimize::Backend& backend, const SparsifyOptions& options,
                     const Control& control) {
  core::require(options.max_percent > 0, "SparsifyOptions::max_percent must be positive");
  StageClock clock("sparsify", control);
  if (auto refusal = refused(network, target, clock)) return std::move(*refusal);
  StageResult result{.network = network};
  const Eigen::VectorXd q = force_densities(network);
  RefineSetup setup{.percent = options.max_percent,
                    .reference = q.mean(),
                    .least_eigenvalue = least_eigenvalue(network, options.outer),
                    .rules = {.longest = options.longest}};
  // mean of sqrt(q) over the cables there are at the start
  const double unit = options.unit / static_cast<double>(q.size());

  const auto attempt = [&](bool external, double weight) {
    (external ? setup.external : setup.internal) = weight * unit;
    Effort effort;
    Refined refined =
        refine(result.network, target, setup, backend, options.outer, control, effort);
    const bool accepted = refined.deviation.max_percent <= options.max_percent &&
                          refined.note.empty() &&
                          stiffest_eigenvalue(refined.network) >= setup.least_eigenvalue;
    clock.count(effort);
    if (!accepted) return false;
    result.network = std::move(refined.network);
    result.trace.push_back(clock.row(result.network, target, weight_note(external, weight)));
    return true;
  };

  const auto& cables = network.structure.cables;
  const auto is_external = [](const springs::Cable& cable) {
    return cable.a.index() == 1 || cable.b.index() == 1;
  };
  for (const bool external : {true, false}) {
    if (std::ranges::none_of(cables,
                             [&](const auto& cable) { return is_external(cable) == external; }))
      continue;
    double good = 0;
    double bad = 0;
    for (const double weight : options.weights) {
      if (clock.stopped()) break;
      if (!attempt(external, weight)) {
        bad = weight;
        break;
      }
      good = weight;
    }
    for (int i = 0; i < options.bisections && good > 0 && bad > 0 && !clock.stopped(); ++i) {
      const double middle = std::sqrt(good * bad);
      (attempt(external, middle) ? good : bad) = middle;
    }
    if (external) setup.external = good * unit;
  }
  finish(result, target, clock);
  return result;
}

}  // namespace tencer::sparsify
