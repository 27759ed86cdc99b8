#include "moves/backward_elimination.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>
#include <utility>

#include "state/final_fit.hpp"

namespace tencer::elimination {
namespace {

using network::Network;

Objective objective_at(const FittedNetwork& fitted, const Descent& descent) {
  const double wanted = std::max(descent.aim_percent, min_distance_percent);
  const double percent =
      std::clamp(2 * fitted.deviation().rms_percent,
                 std::max(descent.min_unit * wanted, min_distance_percent), wanted);
  return {.norm = {.unit = percent / 100 * descent.diagonal},
          .stability_weight = descent.stability_weight};
}

// Orbits from the cheapest to remove on; those without which the network would not be stable come
// last.
std::vector<int> removal_order(const FittedNetwork& fitted, const GaussNewtonModel& model,
                               const RemovalOptions& options) {
  Eigen::VectorXd costs = model.removal_costs();
  const Eigen::VectorXd instability = fitted.removal_instability(model.local());
  for (Eigen::Index o = 0; o < costs.size(); ++o)
    costs[o] += std::isfinite(instability[o]) ? instability[o] : options.unstable_cost;
  std::vector<int> order(static_cast<std::size_t>(costs.size()));
  std::iota(order.begin(), order.end(), 0);
  std::ranges::sort(order, {}, [&](int o) { return std::pair(costs[o], o); });
  return order;
}

// Takes out many of the cheapest at once while there are many.
bool remove_batch(FittedNetwork& fitted, const GaussNewtonModel& model,
                  const std::vector<int>& order, int min_cables, const RemovalOptions& options) {
  std::size_t tied = 0;
  for (const auto& orbit : model.local().orbits) tied += orbit.size();
  const auto largest = static_cast<int>(tied / order.size());  // mostly, of orbits
  const int batch = std::min(static_cast<int>(order.size()) / options.batch_divisor,
                             (fitted.cables() - min_cables) / largest);
  if (batch < 2) return false;
  const std::vector<int> out(order.begin(), order.begin() + batch);
  return fitted.move(model.local(), model.step(out), out, options.jumped);
}

// The best of a few removals, or the first that is good enough; false: none succeeded.
bool remove_next(FittedNetwork& fitted, int min_cables, const RemovalOptions& options) {
  const Network before = fitted.network();
  const double good = std::max(options.growth * fitted.value(), options.good);
  const auto refit = [&] {
    if (fitted.value() > options.good) fitted.refit(options.refits);
    return fitted.value() <= good;
  };
  const GaussNewtonModel model = fitted.gauss_newton_model();
  const auto order = removal_order(fitted, model, options);
  if (remove_batch(fitted, model, order, min_cables, options)) {
    if (refit()) return true;
    if (!fitted.restart(before)) return false;
  }
  std::optional<Network> best;
  double least = std::numeric_limits<double>::infinity();
  const auto tries = std::min(order.size(), static_cast<std::size_t>(options.tries));
  for (std::size_t k = 0; k < tries && !fitted.stopped(); ++k) {
    if (k > 0 && !fitted.restart(before)) return false;
    if (!remove(fitted, order[k], options)) continue;
    if (refit()) return true;
    if (fitted.value() < least) {
      least = fitted.value();
      best = fitted.network();
    }
  }
  return best && fitted.restart(*best);
}

}  // namespace

bool remove(FittedNetwork& fitted, int orbit, const RemovalOptions& options) {
  const double max_value = options.jumped;
  for (const double damping_factor : {1.0, 10.0}) {
    const GaussNewtonModel model = fitted.gauss_newton_model(damping_factor);
    if (fitted.move(model.local(), model.step({orbit}), {orbit}, max_value)) return true;
  }
  double part = 0.5;
  double damping_factor = 10;
  for (int step = 0; step < options.gradual_steps && !fitted.stopped(); ++step) {
    const GaussNewtonModel model = fitted.gauss_newton_model(damping_factor);
    if (step > 0 && fitted.move(model.local(), model.step({orbit}), {orbit}, max_value))
      return true;
    if (fitted.move(model.local(), model.step({orbit}, part), {}, max_value)) {
      part = std::min(0.75, 1.5 * part);
    } else {
      part /= 2;
      damping_factor *= 4;
      if (part < options.min_part) return false;
    }
  }
  return false;
}

std::vector<Network> eliminate_backward(FittedNetwork& fitted, const Descent& descent,
                                        const RemovalOptions& options) {
  std::vector<Network> path;
  fitted.set(objective_at(fitted, descent));
  fitted.refit(options.refits);
  path.push_back(fitted.network());
  while (fitted.cables() > descent.min_cables && !fitted.stopped()) {
    fitted.set(objective_at(fitted, descent));
    if (!remove_next(fitted, descent.min_cables, options)) break;
    path.push_back(fitted.network());
    if (descent.progress) descent.progress(fitted);
    if (fitted.deviation().max_percent > descent.max_percent) break;
  }
  return path;
}

}  // namespace tencer::elimination
