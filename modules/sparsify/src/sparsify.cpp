#include <algorithm>
#include <cmath>
#include <cstdio>
#include <tencer/core/error.hpp>
#include <tencer/network/rest_length.hpp>
#include <tencer/network/stage_recorder.hpp>
#include <tencer/sparsify/sparsify.hpp>

#include "rounds.hpp"

namespace tencer::sparsify {
namespace {

std::string weight_note(bool external, double weight) {
  char text[64];
  std::snprintf(text, sizeof text, "%s weight %.3g", external ? "external" : "internal", weight);
  return text;
}

}  // namespace

void SparsifyOptions::validate() const {
  core::require(max_error_percent > 0, "SparsifyOptions::max_error_percent must be positive");
  core::require(unit > 0, "SparsifyOptions::unit must be positive");
  core::require(!weights.empty() && weights[0] >= 0 && std::ranges::is_sorted(weights),
                "SparsifyOptions::weights must increase and not be negative");
  core::require(bisections >= 0, "SparsifyOptions::bisections must not be negative");
  core::require(max_cable_length > 0, "SparsifyOptions::max_cable_length must be positive");
  outer.validate();
}

network::StageResult sparsify(const network::Network& network, const model::Target& target,
                              const optimize::Backend& backend, const SparsifyOptions& options,
                              const network::Control& control) {
  options.validate();
  network::StageRecorder recorder("sparsify", control);
  if (auto refusal = recorder.refusal(network, target)) return std::move(*refusal);
  network::StageResult result{.network = network};
  const Eigen::VectorXd q = force_densities(network);
  RoundsSetup setup{.unit_percent = options.max_error_percent,
                    .reference = q.mean(),
                    .min_eigenvalue = min_eigenvalue(network, options.outer),
                    .rules = {.max_cable_length = options.max_cable_length}};
  // mean of sqrt(q) over the cables there are at the start
  const double unit = options.unit / static_cast<double>(q.size());

  const auto attempt = [&](bool external, double weight) {
    (external ? setup.external : setup.internal) = weight * unit;
    network::SolveCounts counts;
    Improved improved =
        improve_in_rounds(result.network, target, setup, backend, options.outer, control, counts);
    const bool accepted = improved.deviation.max_percent <= options.max_error_percent &&
                          improved.note.empty() &&
                          stiffest_eigenvalue(improved.network) >= setup.min_eigenvalue;
    recorder.add(counts);
    if (!accepted) return false;
    result.network = std::move(improved.network);
    result.trace.push_back(recorder.row(result.network, target, weight_note(external, weight)));
    return true;
  };

  const auto& cables = network.structure.cables;
  for (const bool external : {true, false}) {
    if (std::ranges::none_of(
            cables, [&](const auto& cable) { return model::is_external(cable) == external; }))
      continue;
    double good = 0;
    double bad = 0;
    for (const double weight : options.weights) {
      if (recorder.stopped()) break;
      if (!attempt(external, weight)) {
        bad = weight;
        break;
      }
      good = weight;
    }
    for (int i = 0; i < options.bisections && good > 0 && bad > 0 && !recorder.stopped(); ++i) {
      const double middle = std::sqrt(good * bad);
      (attempt(external, middle) ? good : bad) = middle;
    }
    if (external) setup.external = good * unit;
  }
  recorder.finish(result, target);
  return result;
}

}  // namespace tencer::sparsify
