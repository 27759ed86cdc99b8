#include <algorithm>
#include <optional>
#include <tencer/core/error.hpp>
#include <tencer/optimize/gauss_newton.hpp>
#include <tencer/sparsify/rest_length.hpp>
#include <tencer/sparsify/thin.hpp>

#include "refine.hpp"
#include "removal_cost.hpp"
#include "stage_clock.hpp"

namespace tencer::sparsify {
namespace {

// RestLengthOptions::margin while cables are taken out.
constexpr double stiff = 0.5;

}  // namespace

StageResult thin(const Network& network, const sensitivity::Target& target, const Rules& rules,
                 const optimize::Backend& backend, const ThinOptions& options,
                 const Control& control) {
  core::require(options.max_percent > 0, "ThinOptions::max_percent must be positive");
  validate(rules, network.structure);
  StageClock clock("thin", control);
  if (auto refusal = refused(network, target, clock)) return std::move(*refusal);
  StageResult result{.network = network};
  const RefineSetup setup{.percent = options.max_percent,
                          .slide = true,
                          .least_eigenvalue = least_eigenvalue(network, options.outer),
                          .rules = rules};

  const double longest = std::max(rules.longest, cable_lengths(network).maxCoeff()) * (1 + 1e-9);

  const auto attempt = [&](const Removal& removal) -> std::optional<Network> {
    Effort effort;
    auto left = moved(result.network, removal.refitted, control, effort);
    if (!left)
      left = without_gradually(result.network, removal.cable, target, setup, control, effort);
    if (left) left = pulling_only(std::move(*left), control, effort);
    if (left) {
      OuterOptions with_hessian = options.outer;
      with_hessian.second_derivatives = SecondDerivatives::gauss_newton;
      const Refined near =
          refine(*left, target, setup, optimize::gauss_newton(), with_hessian, control, effort);
      Refined refined =
          refine(near.network, target, setup, backend, options.outer, control, effort);
      left.reset();
      if (refined.note.empty() && refined.deviation.max_percent <= options.max_percent &&
          cable_lengths(refined.network).maxCoeff() <= longest &&
          stiffest_eigenvalue(refined.network) >= setup.least_eigenvalue)
        left = std::move(refined.network);
    }
    clock.count(effort);
    return left;
  };
  const auto take_one_out = [&] {
    Effort effort;
    // Stiff springs hold on to the shape while one of them goes.
    const auto rest = smallest_stable_rest_length(result.network, {.margin = stiff});
    if (rest.stable) result.network = rebased(std::move(result.network), rest.rho);
    auto order = removals(result.network, target, setup, control, effort);
    clock.count(effort);
    order.resize(std::min(order.size(), static_cast<std::size_t>(options.tries)));
    for (const auto& removal : order) {
      if (clock.stopped()) return false;
      if (auto left = attempt(removal)) {
        result.network = std::move(*left);
        return true;
      }
    }
    return false;
  };

  while (static_cast<int>(result.network.structure.cables.size()) > std::max(options.cables, 1) &&
         !clock.stopped() && take_one_out())
    result.trace.push_back(clock.row(result.network, target));
  finish(result, target, clock);
  return result;
}

}  // namespace tencer::sparsify
