#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <tencer/core/error.hpp>
#include <tencer/equilibrium/solve.hpp>
#include <tencer/sparsify/balance.hpp>
#include <tencer/symmetry/tie.hpp>
#include <utility>

#include "fit.hpp"
#include "soft_modes.hpp"
#include "stage_clock.hpp"
#include "target_balance.hpp"

namespace tencer::sparsify {
namespace {

// The shortest candidate between two groups of rods, null when there is none.
const Pulls* shortest_joining(const equilibrium::Structure& structure,
                              const std::vector<Pulls>& pulls) {
  const auto groups = equilibrium::groups(structure);
  const Pulls* shortest = nullptr;
  for (const Pulls& candidate : pulls) {
    const springs::Cable& cable = candidate.front().cable;
    const auto* a = std::get_if<springs::OnRod>(&cable.a);
    const auto* b = std::get_if<springs::OnRod>(&cable.b);
    const bool joins = a && b && groups[a->rod] != groups[b->rod];
    if (joins && (!shortest || candidate.front().length < shortest->front().length))
      shortest = &candidate;
  }
  return shortest;
}

// Adds, one at a time, candidates that join groups of rods which are free of each other, then those
// that resist the network's softest motions most, until all are clearly stable where the rods are;
// a network that stays unstable shows when it is solved for.
void stabilise(Network& network, const std::vector<Pulls>& pulls, double tension, double rho,
               const Control& control) {
  constexpr int most = 40;
  constexpr double margin = 5000;  // in the unit of eigenvalues: ten times a free straight rod's
  equilibrium::Linearisation at;
  for (int added = 0; added < most && !control.stop.stop_requested(); ++added) {
    const equilibrium::System system(network.structure);
    equilibrium::linearise(system, network.state, at);
    if (equilibrium::free_groups(at.rigid) > 1)
      if (const Pulls* joining = shortest_joining(network.structure, pulls)) {
        for (const Pull& pull : *joining)
          network.structure.cables.push_back(cable_of(pull, tension, rho));
        continue;
      }
    linalg::SymmetricMatrix shifted = at.matrix;
    const Eigen::VectorXd shift = margin * eigenvalue_unit(system) * lumped_mass(system);
    for (int i = 0; i < shifted.cols(); ++i) shifted.coeffRef(i, i) -= shift[i];
    linalg::SymmetricFactor factor;
    if (!factor.factorise(shifted)) return;
    if (factor.inertia().negative == system.saddle_unknowns()) return;
    const Eigen::VectorXd motion = factor.negative_curvature();
    if (motion.size() == 0) return;
    const Pulls* best = nullptr;
    double most_stretch = 0;
    for (const Pulls& candidate : pulls) {
      double squared = 0;
      for (const Pull& pull : candidate) {
        double stretch = 0;
        for_each_unknown(system, pull,
                         [&](int i, double weight) { stretch += weight * motion[i]; });
        squared += stretch * stretch / static_cast<double>(candidate.size());
      }
      if (squared > most_stretch) {
        most_stretch = squared;
        best = &candidate;
      }
    }
    if (!best) return;
    for (const Pull& pull : *best) network.structure.cables.push_back(cable_of(pull, tension, rho));
  }
}

// Cables that hardly stretch go slack when the rods settle a little off the target. Either their
// rest lengths are set anew, for the tensions they had, or they are left out.
enum class Slack { tightened, left_out };

// Takes these cables out, with the others of their orbits.
void leave_out(const std::vector<int>& idle, const symmetry::Group* symmetry,
               std::vector<springs::Cable>& cables) {
  std::vector<int> orbit(cables.size());
  std::iota(orbit.begin(), orbit.end(), 0);
  if (symmetry) orbit = symmetry::tie_cables(cables, *symmetry).orbit;
  std::vector<int> orbits;
  for (const int c : idle) orbits.push_back(orbit[c]);
  for (int c = static_cast<int>(cables.size()) - 1; c >= 0; --c)
    if (std::ranges::find(orbits, orbit[c]) != orbits.end()) cables.erase(cables.begin() + c);
}

// The equilibrium found from the network's state; false: not all cables pull there.
bool settle(Network& network, Slack slack, const symmetry::Group* symmetry, const Control& control,
            Effort& effort) {
  constexpr int rounds = 15;
  const equilibrium::State start = network.state;
  Eigen::VectorXd tensions = cable_tensions(network);
  equilibrium::SolveOptions solve = control.solve;
  solve.stop = control.stop;
  for (int round = 0; round < rounds; ++round) {
    auto solved = equilibrium::solve(equilibrium::System(network.structure),
                                     slack == Slack::tightened ? network.state : start, solve);
    ++effort.solves;
    effort.iterations += solved.iterations;
    network.state = std::move(solved.state);
    const auto idle = idle_cables(network);
    if (!solved.usable() || idle.empty()) return solved.usable();
    auto& cables = network.structure.cables;
    if (slack == Slack::tightened) {
      const Eigen::VectorXd lengths = cable_lengths(network);
      for (Eigen::Index c = 0; c < lengths.size(); ++c)
        cables[c].rest_length = lengths[c] - tensions[c] / cables[c].stiffness;
    } else {
      leave_out(idle, symmetry, cables);
    }
  }
  return false;
}

// The network that balances the forces to `accuracy` (a length), settled by the treatment that ends
// closest to the target; false: with none do all cables pull in equilibrium.
bool settle_balanced(const Network& bare, const sensitivity::Target& target,
                     const std::vector<Pulls>& pulls, const symmetry::Group* symmetry,
                     double accuracy, double percent, const Control& control, Effort& effort,
                     Network& best) {
  const auto found =
      balance_forces(equilibrium::System(bare.structure), bare.state, pulls, accuracy);
  best = bare;
  if (found.set.empty()) {  // the rods may hold the target by themselves
    const bool holds = settle(best, Slack::tightened, symmetry, control, effort);
    return holds && sensitivity::deviation(target, best.state).max_percent < 2 * percent;
  }
  constexpr double gentle = 0.1;  // tension of further cables, of the typical one
  // Which treatment is best differs from case to case, and all are quick.
  struct Treatment {
    double rho;  // rest length relative to length
    Slack slack;
  };
  double closest = std::numeric_limits<double>::infinity();
  for (const auto& [rho, slack] :
       {Treatment{0.999, Slack::tightened}, Treatment{0.99, Slack::left_out},
        Treatment{0.999, Slack::left_out}}) {
    Network network = bare;
    for (std::size_t i = 0; i < found.set.size(); ++i)
      for (const Pull& pull : pulls[found.set[i]])
        network.structure.cables.push_back(
            cable_of(pull, found.values[static_cast<Eigen::Index>(i)], rho));
    stabilise(network, pulls, gentle * found.values.mean(), rho, control);
    const bool sound = settle(network, slack, symmetry, control, effort);
    const double reached = sensitivity::deviation(target, network.state).max_percent;
    // A network that is not sound is better than none, for what is said of it.
    if (best.structure.cables.empty() || (sound && reached < closest)) best = std::move(network);
    if (sound) closest = std::min(closest, reached);
    if (closest < 2 * percent) break;
  }
  return std::isfinite(closest);
}

}  // namespace

StageResult balance(const Network& bare, const sensitivity::Target& target,
                    std::span<const springs::Cable> candidates, const symmetry::Group* symmetry,
                    const BalanceOptions& options, const Control& control) {
  core::require(options.percent > 0, "BalanceOptions::percent must be positive");
  core::require(bare.structure.cables.empty(), "balance: starts without cables");
  StageClock clock("balance", control);
  StageResult result{.network = bare};
  const auto pulls =
      pulls_at(equilibrium::System(bare.structure), bare.state, candidates, symmetry);
  const double diagonal = diagonal_of(target);
  // A finer balance has more cables, which hold better: with few, as symmetric ones may be, the
  // rods can slip into another shape where all is in equilibrium too.
  const double slipped = 10 * options.percent;
  double closest = std::numeric_limits<double>::infinity();
  Effort effort;
  for (const double finer : {1.0, 0.25, 0.05, 0.01}) {
    Network network;
    const bool sound =
        settle_balanced(bare, target, pulls, symmetry, finer * options.percent / 100 * diagonal,
                        options.percent, control, effort, network);
    const double reached = sensitivity::deviation(target, network.state).max_percent;
    if (sound ? reached < closest : std::isinf(closest)) result.network = std::move(network);
    if (sound) closest = std::min(closest, reached);
    if (closest < slipped || clock.stopped()) break;
  }
  clock.count(effort);
  finish(result, target, clock);
  return result;
}

}  // namespace tencer::sparsify
