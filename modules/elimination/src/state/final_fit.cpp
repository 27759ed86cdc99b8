#include "state/final_fit.hpp"

#include <algorithm>

#include "state/fit_problem.hpp"

namespace tencer::elimination {
namespace {

// One round of the outer optimizer.
void optimize_once(FittedNetwork& fitted, const FitOptions& options) {
  const optimize::Backend& backend = *options.optimizer;
  const bool supplied =
      backend.uses_hessian && options.second_derivatives == model::SecondDerivatives::gauss_newton;
  const int iterations = supplied ? options.iterations : options.iterations_without;
  FitProblem fit(fitted, options.max_change);
  const auto report = backend.minimise(
      fit.problem(), fit.start(),
      {.max_evaluations = 3 * iterations,
       .max_iterations = iterations,
       .gradient_tolerance = 1e-4,
       .value_tolerance = 1e-5,
       .initial_step = 0.5,
       .curvature = supplied ? optimize::Curvature::supplied : optimize::Curvature::limited_memory,
       .stop = fitted.stop_token(),
       .progress = [&](const optimize::Progress& progress) { fit.move_to(progress.point); }});
  static_cast<void>(report);  // the fit keeps the best of what was tried, however the run ended
  fit.finish();
}

}  // namespace

void fit_closely(FittedNetwork& fitted, model::Measure measure, double stability_weight,
                 double min_percent, const FitOptions& options) {
  min_percent = std::max(min_percent, min_distance_percent);
  const double diagonal = model::diagonal(fitted.requirements().target);
  const bool largest = measure == model::Measure::max;
  const auto error = [&] {
    return largest ? fitted.deviation().max_percent : fitted.deviation().rms_percent;
  };
  for (int round = 0; round < options.rounds; ++round) {
    const double before = error();
    fitted.set({.norm = {.unit = std::max(before, min_percent) / 100 * diagonal,
                         .power = largest && round > 0 ? options.power : 2.0},
                .stability_weight = stability_weight,
                .buildable = true});
    if (options.optimizer && fitted.cables() > 0)
      optimize_once(fitted, options);
    else
      fitted.refit(options.steps, options.min_gain);
    if (round > 0 && error() > (1 - options.min_round_gain) * before) break;
  }
}

}  // namespace tencer::elimination
