#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <tencer/core/error.hpp>
#include <tencer/equilibrium/modal.hpp>
#include <tencer/ground_structure/balanced_tensions.hpp>
#include <tencer/ground_structure/feasibility.hpp>
#include <tencer/ground_structure/force_balance.hpp>
#include <tencer/network/rest_length.hpp>
#include <tencer/network/stage_recorder.hpp>
#include <tencer/sensitivity/distance.hpp>
#include <tencer/springs/law.hpp>
#include <tencer/symmetry/tie.hpp>
#include <utility>

namespace tencer::ground_structure {
namespace {

using network::Network;

// How much of a candidate's stretch the rigid motions can make that `modes` has, one entry for each
// component of rods: a cosine.
double stretched(const equilibrium::System& system,
                 const std::vector<equilibrium::RigidModes>& modes, const CandidateOrbit& orbit) {
  const CandidateColumn& column = orbit.front();
  double squared = 0;
  double all = 0;
  for (const equilibrium::RigidModes& component : modes) {
    if (component.basis.cols() == 0) continue;
    Eigen::VectorXd stretch = Eigen::VectorXd::Zero(component.basis.cols());
    for_each_unknown(system, column,
                     [&](int i, double weight) { stretch += weight * component.basis.row(i); });
    squared += stretch.squaredNorm();
  }
  for_each_unknown(system, column, [&](int, double weight) { all += weight * weight; });
  return all > 0 ? std::sqrt(squared / all) : 0.0;
}

// The candidates that rigid motions stretch which cost the structure nothing. None: it has no such
// motion, or moves as a whole.
std::vector<const CandidateOrbit*> ties_of(const model::Structure& structure,
                                           const model::State& state,
                                           const std::vector<CandidateOrbit>& orbits) {
  constexpr double least = 0.01;  // of those that they stretch most
  const bool held =
      !structure.pins.empty() || std::ranges::any_of(structure.cables, model::is_external);
  const equilibrium::System system(structure);
  const auto modes = equilibrium::rigid_modes(system, state);
  if (equilibrium::floating_components(modes) <= (held ? 0 : 1)) return {};
  std::vector<double> stretch;
  for (const CandidateOrbit& orbit : orbits) stretch.push_back(stretched(system, modes, orbit));
  const double most = orbits.empty() ? 0.0 : *std::ranges::max_element(stretch);
  std::vector<const CandidateOrbit*> ties;
  if (!(most > 1e-9)) return ties;
  for (std::size_t i = 0; i < orbits.size(); ++i)
    if (stretch[i] > least * most) ties.push_back(&orbits[i]);
  return ties;
}

// None of no candidates.
const CandidateOrbit* shortest(const std::vector<const CandidateOrbit*>& orbits) {
  const auto at =
      std::ranges::min_element(orbits, {}, [](const auto* orbit) { return orbit->front().length; });
  return at == orbits.end() ? nullptr : *at;
}

// At most `count` of the candidates, the shortest first, then each as far from the others as can
// be: both ends count.
std::vector<const CandidateOrbit*> spread(const std::vector<const CandidateOrbit*>& orbits,
                                          const model::State& state, int count) {
  const auto ends = [&](const CandidateOrbit& orbit) {
    Eigen::Matrix<double, 6, 1> both = Eigen::Matrix<double, 6, 1>::Zero();
    const CandidateColumn& column = orbit.front();
    for (int i = 0; i < column.stencil.count; ++i) {
      const springs::Share& share = column.stencil.shares[i];
      // Vertices of end a have negative weights.
      both.segment<3>(share.weight < 0 ? 0 : 3) +=
          std::abs(share.weight) * state[share.rod].x.col(share.vertex);
    }
    if (std::holds_alternative<springs::AtAnchor>(column.cable.a))
      both.head<3>() = both.tail<3>() - column.length * column.direction;
    if (std::holds_alternative<springs::AtAnchor>(column.cable.b))
      both.tail<3>() = both.head<3>() + column.length * column.direction;
    return both;
  };
  std::vector<const CandidateOrbit*> chosen;
  const CandidateOrbit* next = shortest(orbits);
  Eigen::VectorXd nearest = Eigen::VectorXd::Constant(static_cast<Eigen::Index>(orbits.size()),
                                                      std::numeric_limits<double>::infinity());
  while (next && static_cast<int>(chosen.size()) < count) {
    chosen.push_back(next);
    const auto at = ends(*next);
    for (std::size_t i = 0; i < orbits.size(); ++i) {
      double& distance = nearest[static_cast<Eigen::Index>(i)];
      distance = std::min(distance, (ends(*orbits[i]) - at).norm());
    }
    Eigen::Index furthest = 0;
    next = nearest.maxCoeff(&furthest) > 0 ? orbits[static_cast<std::size_t>(furthest)] : nullptr;
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
// ties what moves at no cost, else the one that resists the softest motion most. null: it is stable
// enough, or nothing helps.
const CandidateOrbit* stabilising(const Network& network, const std::vector<CandidateOrbit>& orbits,
                                  double margin) {
  if (const auto* tie = shortest(ties_of(network.structure, network.state, orbits))) return tie;
  const equilibrium::System system(network.structure);
  equilibrium::Linearisation at;
  equilibrium::linearise(system, network.state, at);
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
    if (ties_of(best.network.structure, best.network.state, orbits_).empty()) return best;
    Balanced tied = balance_from(tied_rods(), accuracy);
    return tied.pulling ? tied : best;
  }

  // The candidates that pull where the rods rest with all of them tied: it does not buckle, but has
  // far more cables.
  Balanced tied_at_rest() {
    Balanced best{.network = problem_.bare()};
    const auto first = relaxation(equilibrium::System(problem_.structure), problem_.start, orbits_);
    if (!first) return best;
    const TiedRest rest =
        tied_rest(problem_, orbits_, *first,
                  {.near_percent = 2 * options_.max_error_percent, .stop = control_.stop});
    const linalg::Nonnegative pulling = pulling_at(rest);
    if (pulling.set.empty()) return best;
    Network at_rest = problem_.bare();
    at_rest.state = rest.state;
    for (const double rest_ratio : {0.999, 0.99}) {
      Balanced next{.network = stabilised(at_rest, pulling, rest_ratio)};
      next.pulling = solve_pulling(next.network, Slack::left_out);
      next.percent = percent_of(next.network);
      if (next.pulling && next.percent < best.percent) best = std::move(next);
      if (best.pulling) break;
    }
    return best;
  }

  const network::SolveCounts& counts() const { return counts_; }

 private:
  // The bare network with ties for what moves at no cost, until nothing does. They are as soft as
  // their tension lets them: stiff ones would hold each other, and the balance would see nothing of
  // their pull.
  Network tied_rods() const {
    Network network = problem_.bare();
    for (std::size_t k = 0; k < problem_.structure.rods.size(); ++k) {
      const auto loose = ties_of(network.structure, network.state, orbits_);
      if (loose.empty()) break;
      for (const CandidateOrbit* orbit : spread(loose, network.state, options_.ties))
        for (auto& cable : cables_of(*orbit, options_.tie_tension, 0))
          network.structure.cables.push_back(cable);
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
      Balanced next{.network = stabilised(stiffened(base, rest_ratio), *found, rest_ratio)};
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

  static linalg::Nonnegative pulling_at(const TiedRest& rest) {
    constexpr double slack = 1e-6;  // of the largest tension
    linalg::Nonnegative result;
    if (!rest.rests || rest.tied.empty()) return result;
    const double least = slack * rest.tensions.maxCoeff();
    std::vector<double> tensions;
    for (std::size_t i = 0; i < rest.tied.size(); ++i)
      if (const double tension = rest.tensions[static_cast<Eigen::Index>(i)]; tension > least) {
        result.set.push_back(rest.tied[i]);
        tensions.push_back(tension);
      }
    result.values =
        Eigen::Map<Eigen::VectorXd>(tensions.data(), static_cast<Eigen::Index>(tensions.size()));
    return result;
  }

  // With ties that hardly stretch.
  Network stiffened(Network network, double rest_ratio) const {
    const Eigen::VectorXd lengths = cable_lengths(network);
    auto& cables = network.structure.cables;
    for (std::size_t c = problem_.structure.cables.size(); c < cables.size(); ++c)
      cables[c] = springs::rebased(cables[c], lengths[static_cast<Eigen::Index>(c)], rest_ratio);
    return network;
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
    solve.max_path_rotation = 1;  // radians: beyond it the rods have gone elsewhere
    for (int round = 0; round < max_rounds; ++round) {
      auto solved = equilibrium::solve(equilibrium::System(network.structure),
                                       slack == Slack::tightened ? network.state : start, solve);
      counts_ += {.solves = 1, .iterations = solved.iterations};
      network.state = std::move(solved.state);
      const auto idle = idle_cables(network);
      if (!solved.usable() || idle.empty()) return solved.usable();
      // Those of the structure that it was called with stay.
      if (slack == Slack::left_out && idle.front() < std::ssize(problem_.structure.cables))
        return false;
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
  core::require(ties > 0, "ForceBalanceOptions::ties must be positive");
  core::require(tie_tension > 0, "ForceBalanceOptions::tie_tension must be positive");
}

network::StageResult force_balance(const Problem& problem, const symmetry::Group* symmetry,
                                   const ForceBalanceOptions& options,
                                   const network::Control& control) {
  options.validate();
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
  // All candidates that are tied at once are those of no symmetry.
  if (!symmetry && closest >= slipped && !recorder.stopped()) {
    auto next = run.tied_at_rest();
    if (next.pulling && next.percent < closest) result.network = std::move(next.network);
  }
  recorder.add(run.counts());
  recorder.finish(result, problem.target);
  return result;
}

}  // namespace tencer::ground_structure
