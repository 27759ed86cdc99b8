#include <tencer/core/error.hpp>
#include <tencer/elimination/options.hpp>

namespace tencer::elimination {

using core::require;

void StepOptions::validate() const {
  require(min_damping > 0 && damping >= min_damping && max_damping >= damping,
          "StepOptions: needs 0 < min_damping <= damping <= max_damping");
  require(max_slide >= 0, "StepOptions::max_slide must not be negative");
  require(kept_density > 0 && kept_density < 1, "StepOptions::kept_density must be in (0, 1)");
  require(tolerance > 0, "StepOptions::tolerance must be positive");
  require(max_turn > 0, "StepOptions::max_turn must be positive");
  require(max_iterations > 0, "StepOptions::max_iterations must be positive");
  require(max_path_rotation > 0, "StepOptions::max_path_rotation must be positive");
  require(attempts > 0, "StepOptions::attempts must be positive");
}

void RemovalOptions::validate() const {
  require(tries > 0, "RemovalOptions::tries must be positive");
  require(batch_divisor > 0, "RemovalOptions::batch_divisor must be positive");
  require(good > 0, "RemovalOptions::good must be positive");
  require(growth >= 1, "RemovalOptions::growth must be at least 1");
  require(refits >= 0, "RemovalOptions::refits must not be negative");
  require(jumped > 0, "RemovalOptions::jumped must be positive");
  require(unstable_cost >= 0, "RemovalOptions::unstable_cost must not be negative");
  require(min_part > 0 && min_part < 1, "RemovalOptions::min_part must be in (0, 1)");
  require(gradual_steps >= 0, "RemovalOptions::gradual_steps must not be negative");
}

void DescentSettings::validate() const {
  require(stability_weight >= 0, "DescentSettings::stability_weight must not be negative");
  require(min_unit > 0, "DescentSettings::min_unit must be positive");
  require(part > 0, "DescentSettings::part must be positive");
  require(times > 0, "DescentSettings::times must be positive");
}

void LocalSearchOptions::validate() const {
  require(patience >= 0, "LocalSearchOptions::patience must not be negative");
  require(max_rounds >= 0, "LocalSearchOptions::max_rounds must not be negative");
  require(candidates > 0, "LocalSearchOptions::candidates must be positive");
  require(alike >= 0 && alike < 1, "LocalSearchOptions::alike must be in [0, 1)");
  require(brace_tension > 0, "LocalSearchOptions::brace_tension must be positive");
}

void FitOptions::validate() const {
  require(second_derivatives != model::SecondDerivatives::exact,
          "FitOptions::second_derivatives: expected gauss_newton or limited_memory");
  require(iterations > 0, "FitOptions::iterations must be positive");
  require(iterations_without > 0, "FitOptions::iterations_without must be positive");
  require(max_change > 0, "FitOptions::max_change must be positive");
  require(rounds > 0, "FitOptions::rounds must be positive");
  require(steps > 0, "FitOptions::steps must be positive");
  require(min_gain >= 0, "FitOptions::min_gain must not be negative");
  require(min_round_gain >= 0, "FitOptions::min_round_gain must not be negative");
  require(further >= 0, "FitOptions::further must not be negative");
  require(power >= 2, "FitOptions::power must be at least 2");
  for (const Attempt& attempt : attempts)
    require(attempt.stability_weight >= 0 && attempt.min_unit >= 0,
            "FitOptions::attempts must not have negative numbers");
}

void StartOptions::validate() const {
  for (const Balance& balance : balances)
    require(balance.part > 0 && balance.descents > 0,
            "StartOptions::balances: part and descents must be positive");
  require(min_error_percent > 0 && max_error_percent >= min_error_percent,
          "StartOptions: needs 0 < min_error_percent <= max_error_percent");
  require(mendable > 0, "StartOptions::mendable must be positive");
  require(min_beam_cables > 0, "StartOptions::min_beam_cables must be positive");
  require(max_seed_order >= 0, "StartOptions::max_seed_order must not be negative");
  require(nearly_symmetric > 0 && nearly_symmetric < 0.05,
          "StartOptions::nearly_symmetric must be in (0, 0.05)");
}

void ProlongOptions::validate() const {
  require(fits_closer >= 1, "ProlongOptions::fits_closer must be at least 1");
  require(spare >= 0, "ProlongOptions::spare must not be negative");
}

void CoarseOptions::validate() const {
  require(min_edges >= 3, "CoarseOptions::min_edges must be at least 3");
  require(max_turn > 0, "CoarseOptions::max_turn must be positive");
  require(worthwhile > 0 && worthwhile <= 1, "CoarseOptions::worthwhile must be in (0, 1]");
}

void BlockOptions::validate() const {
  require(some_rods > 1, "BlockOptions::some_rods must be at least 2");
  require(many_rods >= some_rods, "BlockOptions::many_rods must be at least some_rods");
  require(max_sweeps >= 0, "BlockOptions::max_sweeps must not be negative");
  require(tried > 0, "BlockOptions::tried must be positive");
  require(refit_above >= 0, "BlockOptions::refit_above must not be negative");
  require(soft_rest_ratio > 0 && soft_rest_ratio < 1,
          "BlockOptions::soft_rest_ratio must be in (0, 1)");
}

void Workmanship::validate() const {
  require(length_error >= 0, "Workmanship::length_error must not be negative");
  require(attachment_error >= 0, "Workmanship::attachment_error must not be negative");
  require(max_deviation > 0, "Workmanship::max_deviation must be positive");
  require(min_tension_ratio >= 0 && min_tension_ratio < 1,
          "Workmanship::min_tension_ratio must be in [0, 1)");
  require(min_tension >= 0, "Workmanship::min_tension must not be negative");
}

void EliminationOptions::validate() const {
  goal.validate();
  require(min_eigenvalue >= 0, "EliminationOptions::min_eigenvalue must not be negative");
  workmanship.validate();
  require(threads > 0, "EliminationOptions::threads must be positive");
  step.validate();
  removal.validate();
  for (const DescentSettings& settings : portfolio) settings.validate();
  local_search.validate();
  fit.validate();
  start.validate();
  coarse.validate();
  prolong.validate();
  block.validate();
}

}  // namespace tencer::elimination
