#include "descent.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <optional>
#include <utility>

namespace tencer::sparsify {
namespace {

constexpr double far = 20;  // objective beyond which an equilibrium has jumped

Drive drive_at(const Walker& walker, const DescentOptions& options) {
  const double wanted = std::max(options.percent, finest_percent);
  const double percent = std::clamp(2 * walker.deviation().rms_percent,
                                    std::max(options.finest * wanted, finest_percent), wanted);
  return {.aim = {.unit = percent / 100 * options.diagonal}, .softness = options.softness};
}

// Takes one orbit out: at once, with more care, then bit by bit.
bool remove(Walker& walker, int orbit) {
  for (const double care : {1.0, 10.0}) {
    const Planner plan = walker.planner(care);
    if (walker.move(plan.model(), plan.step({orbit}), {orbit}, far)) return true;
  }
  constexpr double least_part = 0.1;
  double part = 0.5;
  double care = 10;
  for (int step = 0; step < 8 && !walker.stopped(); ++step) {
    const Planner plan = walker.planner(care);
    if (step > 0 && walker.move(plan.model(), plan.step({orbit}), {orbit}, far)) return true;
    if (walker.move(plan.model(), plan.step({orbit}, part), {}, far)) {
      part = std::min(0.75, 1.5 * part);
    } else {
      part /= 2;
      care *= 4;
      if (part < least_part) return false;
    }
  }
  return false;
}

// Orbits from the cheapest to remove on; those without which the network would not be stable come
// last.
std::vector<int> removal_order(const Walker& walker, const Planner& plan) {
  Eigen::VectorXd costs = plan.removal_costs();
  const Eigen::VectorXd soft = walker.removal_softness(plan.model());
  constexpr double unstable = 1e3;
  for (Eigen::Index o = 0; o < costs.size(); ++o)
    costs[o] += std::isfinite(soft[o]) ? soft[o] : unstable;
  std::vector<int> order(static_cast<std::size_t>(costs.size()));
  std::iota(order.begin(), order.end(), 0);
  std::ranges::sort(order, {}, [&](int o) { return std::pair(costs[o], o); });
  return order;
}

// Takes out many of the cheapest at once while there are many.
bool remove_several(Walker& walker, const Planner& plan, const std::vector<int>& order,
                    int fewest) {
  std::size_t tied = 0;
  for (const auto& orbit : plan.model().orbits) tied += orbit.size();
  const auto largest = static_cast<int>(tied / order.size());  // mostly, of orbits
  const int several =
      std::min(static_cast<int>(order.size()) / 6, (walker.cables() - fewest) / largest);
  if (several < 2) return false;
  const std::vector<int> out(order.begin(), order.begin() + several);
  return walker.move(plan.model(), plan.step(out), out, far);
}

// The best of a few removals, or the first that is good enough; false: none succeeded.
bool remove_one(Walker& walker, const DescentOptions& options) {
  constexpr double fits_well = 0.3;
  constexpr double growth = 1.5;
  const Network before = walker.network();
  const double good = std::max(growth * walker.value(), fits_well);
  std::optional<Network> best;
  double least = std::numeric_limits<double>::infinity();
  const Planner plan = walker.planner();
  const auto order = removal_order(walker, plan);
  if (remove_several(walker, plan, order, options.fewest)) {
    if (walker.value() > fits_well) walker.refit(3);
    if (walker.value() <= good) return true;
    if (!walker.restart(before)) return false;
  }
  const auto tries = std::min(order.size(), static_cast<std::size_t>(options.tries));
  for (std::size_t k = 0; k < tries && !walker.stopped(); ++k) {
    if (k > 0 && !walker.restart(before)) return false;
    if (!remove(walker, order[k])) continue;
    if (walker.value() > fits_well) walker.refit(3);
    if (walker.value() <= good) return true;
    if (walker.value() < least) {
      least = walker.value();
      best = walker.network();
    }
  }
  return best && walker.restart(*best);
}

}  // namespace

std::vector<Network> descend(Walker& walker, const DescentOptions& options) {
  std::vector<Network> path;
  walker.set(drive_at(walker, options));
  walker.refit(3);
  path.push_back(walker.network());
  while (walker.cables() > options.fewest && !walker.stopped()) {
    walker.set(drive_at(walker, options));
    if (!remove_one(walker, options)) break;
    path.push_back(walker.network());
    if (options.progress) options.progress(walker);
    if (walker.deviation().max_percent > options.hopeless) break;
  }
  return path;
}

}  // namespace tencer::sparsify
