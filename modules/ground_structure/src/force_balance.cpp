#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <tencer/core/error.hpp>
#include <tencer/equilibrium/modal.hpp>
#include <tencer/ground_structure/balanced_tensions.hpp>
#include <tencer/ground_structure/force_balance.hpp>
#include <tencer/network/rest_length.hpp>
#include <tencer/network/stage_recorder.hpp>
#include <tencer/sensitivity/distance.hpp>
#include <tencer/symmetry/tie.hpp>
#include <utility>

namespace tencer::ground_structure {
namespace {

using network::Network;

// Whether it is between rods of different components.
bool joins(const CandidateOrbit& orbit, const std::vector<int>& components) {
  const springs::Cable& cable = orbit.front().cable;
  const auto* a = std::get_if<springs::OnRod>(&cable.a);
  const auto* b = std::get_if<springs::OnRod>(&cable.b);
  return a && b && components[a->rod] != components[b->rod];
}

// The shortest candidate between two components of rods, null when there is none.
const CandidateOrbit* shortest_joining(const model::Structure& structure,
                                       const std::vector<CandidateOrbit>& orbits) {
  const auto components = model::components(structure);
  const CandidateOrbit* shortest = nullptr;
  for (const CandidateOrbit& orbit : orbits) {
    if (joins(orbit, components) && (!shortest || orbit.front().length < shortest->front().length))
      shortest = &orbit;
  }
  return shortest;
}

// Candidates between components of rods, at most `count`, the shortest first, then each as far from
// the others as can be: both ends count.
std::vector<const CandidateOrbit*> spread_joining(const model::Structure& structure,
                                                  const model::State& state,
                                                  const std::vector<CandidateOrbit>& orbits,
                                                  int count) {
  const auto components = model::components(structure);
  const auto ends = [&](const CandidateOrbit& orbit) {
    Eigen::Matrix<double, 6, 1> both = Eigen::Matrix<double, 6, 1>::Zero();
    const springs::Stencil& stencil = orbit.front().stencil;
    for (int i = 0; i < stencil.count; ++i) {
      const springs::Share& share = stencil.shares[i];
      // Vertices of end a have negative weights.
      both.segment<3>(share.weight < 0 ? 0 : 3) +=
          std::abs(share.weight) * state[share.rod].x.col(share.vertex);
    }
    return both;
  };
  std::vector<const CandidateOrbit*> joining;
  for (const CandidateOrbit& orbit : orbits)
    if (joins(orbit, components)) joining.push_back(&orbit);
  std::vector<const CandidateOrbit*> chosen;
  const CandidateOrbit* next = shortest_joining(structure, orbits);
  Eigen::VectorXd nearest = Eigen::VectorXd::Constant(static_cast<Eigen::Index>(joining.size()),
                                                      std::numeric_limits<double>::infinity());
  while (next && static_cast<int>(chosen.size()) < count) {
    chosen.push_back(next);
    const auto at = ends(*next);
    for (std::size_t i = 0; i < joining.size(); ++i) {
      double& distance = nearest[static_cast<Eigen::Index>(i)];
      distance = std::min(distance, (ends(*joining[i]) - at).norm());
    }
    Eigen::Index furthest = 0;
    next = nearest.maxCoeff(&furthest) > 0 ? joining[static_cast<std::size_t>(furthest)] : nullptr;
  }
  return chosen;
}

// The candidate that a motion stretches most, null when it stretches none.
const CandidateOrbit* most_stretched(const equilibrium::System& system,
                                     const std::vector<CandidateOrbit>& orbits,
                                     const Eigen::VectorXd& motion) {
  const CandidateOrbit* best = nullptr;
  double max_squared = 0;
  for (const CandidateOrbit& orbit : orbits) {
    double squared = 0;
    for (const CandidateColumn& column : orbit) {
      double stretch = 0;
      for_each_unknown(system, column,
                       [&](int i, double weight) { stretch += weight * motion[i]; });
      squared += stretch * stretch / static_cast<double>(orbit.size());
    }
    if (squared > max_squared) {
      max_squared = squared;
      best = &orbit;
    }
  }
  return best;
}

// The candidate to add next to a network that is not stable enough where its rods are: one that
// joins components which are free of each other, else the one that resists the softest motion most.
// null: it is stable enough, or nothing helps.
const CandidateOrbit* stabilising(const Network& network, const std::vector<CandidateOrbit>& orbits,
                                  double margin) {
  const equilibrium::System system(network.structure);
  equilibrium::Linearisation at;
  equilibrium::linearise(system, network.state, at);
  if (equilibrium::floating_components(at.rigid) > 1)
    if (const auto* joining = shortest_joining(network.structure, orbits)) return joining;
  linalg::SymmetricFactor factor;
  if (!factor.factorise(equilibrium::shifted(system, std::move(at.matrix), margin))) return nullptr;
  if (factor.inertia().negative == system.saddle_unknowns()) return nullptr;
  const Eigen::VectorXd motion = factor.negative_curvature();
  return motion.size() == 0 ? nullptr : most_stretched(system, orbits, motion);
}

// What is done about cables that go slack when the rods settle a little off the target, as cables
// that hardly stretch do.
enum class Slack {
  tightened,  // their rest lengths are set anew, for the tensions they had
  left_out
};

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

// One run of force_balance.
class Run {
 public:
  Run(const Problem& problem, const symmetry::Group* symmetry, const ForceBalanceOptions& options,
      const network::Control& control)
      : problem_(problem),
        symmetry_(symmetry),
        options_(options),
        control_(control),
        orbits_(candidate_orbits(equilibrium::System(problem.structure), problem.start,
                                 problem.candidates, symmetry)) {}

  struct Balanced {
    Network network{};
    bool pulling = false;  // in equilibrium, and all cables pull
    double percent = std::numeric_limits<double>::infinity();  // distance of the equilibrium found
  };

  // The network that balances the forces to `accuracy` (a length). Rods that rest without cables
  // between them may leave groups untied: then they are tied with some tension before the balance,
  // which then holds against it.
  Balanced balance(double accuracy) {
    Balanced best = balance_from(problem_.bare(), accuracy);
    if (floating(best.network) <= 1) return best;
    Balanced tied = balance_from(tied_rods(), accuracy);
    return tied.pulling ? tied : best;
  }

  const network::SolveCounts& counts() const { return counts_; }

 private:
  // All rods tied to each other, each pair of components with as many cables as it takes to hold a
  // body in space that can only be pulled at.
  Network tied_rods() const {
    constexpr int cables_of_tie = 7;
    constexpr double tension = 1;  // EI / L^2
    Network network = problem_.bare();
    const auto rods = static_cast<int>(problem_.structure.rods.size());
    for (int k = 1; k < rods; ++k) {
      const auto joining = spread_joining(network.structure, network.state, orbits_, cables_of_tie);
      for (const CandidateOrbit* orbit : joining)
        for (auto& cable : cables_of(*orbit, tension, network::stiff_rest_ratio))
          network.structure.cables.push_back(cable);
      const auto components = model::components(network.structure);
      if (*std::ranges::max_element(components) == 0) break;
    }
    return network;
  }

  // The network `base` with cables that balance its forces, settled by the treatment of slack
  // cables that ends closest to the target.
  Balanced balance_from(const Network& base, double accuracy) {
    Balanced best{.network = base};
    const auto found =
        balanced_tensions(equilibrium::System(base.structure), problem_.start, orbits_, accuracy);
    if (!found) return best;
    if (found->set.empty()) {  // the rods may hold the target by themselves
      best.pulling = solve_pulling(best.network, Slack::tightened);
      best.percent = percent_of(best.network);
      best.pulling = best.pulling && best.percent < 2 * options_.max_error_percent;
      return best;
    }
    // Which treatment is best differs from case to case, and all are quick.
    struct Treatment {
      double rest_ratio;
      Slack slack;
    };
    for (const auto& [rest_ratio, slack] :
         {Treatment{0.999, Slack::tightened}, Treatment{0.99, Slack::left_out},
          Treatment{0.999, Slack::left_out}}) {
      Balanced next{.network = stabilised(base, *found, rest_ratio)};
      next.pulling = solve_pulling(next.network, slack);
      next.percent = percent_of(next.network);
      // A network with slack cables is better than none, for what is said of it.
      const bool none_yet = best.network.structure.cables.empty();
      const bool closer = next.pulling && (!best.pulling || next.percent < best.percent);
      if (none_yet || closer) best = std::move(next);
      if (best.pulling && best.percent < 2 * options_.max_error_percent) break;
    }
    return best;
  }

  static int floating(const Network& network) {
    const equilibrium::System system(network.structure);
    return equilibrium::floating_components(equilibrium::rigid_modes(system, network.state));
  }

  double percent_of(const Network& network) const {
    return sensitivity::deviation(problem_.target, network.state).max_percent;
  }

  // `base` and the network of these tensions at the target, with cables added until it is stable
  // there; one that stays unstable shows when it is solved for.
  Network stabilised(Network network, const linalg::Nonnegative& tensions,
                     double rest_ratio) const {
    const auto add = [&](const CandidateOrbit& orbit, double tension) {
      for (auto& cable : cables_of(orbit, tension, rest_ratio))
        network.structure.cables.push_back(cable);
    };
    for (std::size_t i = 0; i < tensions.set.size(); ++i)
      add(orbits_[tensions.set[i]], tensions.values[static_cast<Eigen::Index>(i)]);
    const double tension = options_.added_tension * tensions.values.mean();
    for (int k = 0; k < options_.max_added && !control_.stop.stop_requested(); ++k) {
      const CandidateOrbit* next = stabilising(network, orbits_, options_.stability_margin);
      if (!next) break;
      add(*next, tension);
    }
    return network;
  }

  // Puts the network in equilibrium, found from its state; false: not all cables pull there.
  bool solve_pulling(Network& network, Slack slack) {
    constexpr int max_rounds = 15;
    const model::State start = network.state;
    const Eigen::VectorXd tensions = cable_tensions(network);
    equilibrium::SolveOptions solve = control_.solve;
    solve.stop = control_.stop;
    for (int round = 0; round < max_rounds; ++round) {
      auto solved = equilibrium::solve(equilibrium::System(network.structure),
                                       slack == Slack::tightened ? network.state : start, solve);
      counts_ += {.solves = 1, .iterations = solved.iterations};
      network.state = std::move(solved.state);
      const auto idle = idle_cables(network);
      if (!solved.usable() || idle.empty()) return solved.usable();
      auto& cables = network.structure.cables;
      if (slack == Slack::tightened) {
        const Eigen::VectorXd lengths = cable_lengths(network);
        for (Eigen::Index c = 0; c < lengths.size(); ++c) {
          const double rest_length = lengths[c] - tensions[c] / cables[c].stiffness;
          if (!(rest_length >= 0)) return false;  // its ends met: the rods have gone elsewhere
          cables[c].rest_length = rest_length;
        }
      } else {
        leave_out(idle, symmetry_, cables);
      }
    }
    return false;
  }

  const Problem& problem_;
  const symmetry::Group* symmetry_;
  const ForceBalanceOptions& options_;
  const network::Control& control_;
  std::vector<CandidateOrbit> orbits_;
  network::SolveCounts counts_;
};

}  // namespace

void ForceBalanceOptions::validate() const {
  core::require(max_error_percent > 0, "ForceBalanceOptions::max_error_percent must be positive");
  core::require(stability_margin > 0, "ForceBalanceOptions::stability_margin must be positive");
  core::require(max_added >= 0, "ForceBalanceOptions::max_added must not be negative");
  core::require(added_tension > 0, "ForceBalanceOptions::added_tension must be positive");
}

network::StageResult force_balance(const Problem& problem, const symmetry::Group* symmetry,
                                   const ForceBalanceOptions& options,
                                   const network::Control& control) {
  options.validate();
  core::require(problem.structure.cables.empty(), "force_balance: starts without cables");
  network::StageRecorder recorder("balance", control);
  network::StageResult result{.network = problem.bare()};
  Run run(problem, symmetry, options, control);
  const double diagonal = model::diagonal(problem.target);
  // A finer balance has more cables, which hold better: with few, as symmetric ones may be, the
  // rods can slip into another shape where all is in equilibrium too.
  const double slipped = 10 * options.max_error_percent;
  double closest = std::numeric_limits<double>::infinity();
  for (const double finer : {1.0, 0.25, 0.05, 0.01}) {
    auto next = run.balance(finer * options.max_error_percent / 100 * diagonal);
    if (next.pulling ? next.percent < closest : std::isinf(closest))
      result.network = std::move(next.network);
    if (next.pulling) closest = std::min(closest, next.percent);
    if (closest < slipped || recorder.stopped()) break;
  }
  recorder.add(run.counts());
  recorder.finish(result, problem.target);
  return result;
}

}  // namespace tencer::ground_structure
