#include <Eigen/Cholesky>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <set>
#include <tencer/core/error.hpp>
#include <tencer/ground_structure/balanced_tensions.hpp>
#include <tencer/ground_structure/beam_search.hpp>
#include <tencer/sensitivity/distance.hpp>
#include <tuple>
#include <utility>

namespace tencer::ground_structure {
namespace {

using network::Network;

// Orbits, by number, with their tensions and the square of what is left of the goal.
struct Set {
  std::vector<int> orbits{};
  Eigen::VectorXd tensions{};
  double rest = 0.0;
  int cables = 0;
};

// The orbits to choose from, and the products of their displacements, worked out when needed.
class Orbits {
 public:
  Orbits(std::vector<CandidateOrbit> orbits, Displacements moved)
      : orbits_(std::move(orbits)),
        columns_(std::move(moved.columns)),
        squares_(columns_.colwise().squaredNorm()),
        slope_(columns_.transpose() * moved.goal),
        goal_(moved.goal.squaredNorm()) {}

  int size() const { return static_cast<int>(orbits_.size()); }
  const CandidateOrbit& operator[](int orbit) const { return orbits_[orbit]; }
  double goal() const { return goal_; }
  // The products of every orbit with itself and with the goal.
  const Eigen::VectorXd& squares() const { return squares_; }
  const Eigen::VectorXd& slope() const { return slope_; }
  // The products of every orbit with this one.
  const Eigen::VectorXd& products(int orbit) {
    auto& known = products_[orbit];
    if (known.size() == 0) known = columns_.transpose() * columns_.col(orbit);
    return known;
  }

 private:
  std::vector<CandidateOrbit> orbits_;
  Eigen::MatrixXd columns_;
  Eigen::VectorXd squares_;
  Eigen::VectorXd slope_;
  double goal_;
  std::map<int, Eigen::VectorXd> products_;
};

// Sets whose cables end in the same parts of the rods are alike: attachments slide later.
using Signature = std::vector<std::array<int, 4>>;
Signature signature_of(const Set& set, const Orbits& orbits, const equilibrium::System& system) {
  constexpr double parts = 32;
  const auto place = [&](const springs::End& end) -> std::array<int, 2> {
    if (const auto* anchor = std::get_if<springs::AtAnchor>(&end)) return {-1 - anchor->anchor, 0};
    const auto& on = std::get<springs::OnRod>(end);
    const geometry::ArcLength& rod = system.arc_lengths()[on.rod];
    return {on.rod, static_cast<int>(rod.wrap(on.s) / rod.length() * parts)};
  };
  Signature signature;
  for (const int orbit : set.orbits) {
    const springs::Cable& cable = orbits[orbit].front().cable;
    auto a = place(cable.a);
    auto b = place(cable.b);
    if (b < a) std::swap(a, b);
    signature.push_back({a[0], a[1], b[0], b[1]});
  }
  std::ranges::sort(signature);
  return signature;
}

// At most so many of them, evenly spread: enough to choose from, on rods however many.
std::vector<CandidateOrbit> some_of(std::vector<CandidateOrbit> all, std::size_t max_count) {
  if (all.size() <= max_count) return all;
  std::vector<CandidateOrbit> some;
  for (std::size_t k = 0; k < max_count; ++k)
    some.push_back(std::move(all[k * all.size() / max_count]));
  return some;
}

// The sets of one orbit more: orthogonal least squares.
void grow(const Set& set, Orbits& orbits, const BeamSearchOptions& options,
          std::vector<Set>& grown) {
  const auto n = static_cast<Eigen::Index>(set.orbits.size());
  Eigen::MatrixXd shared(orbits.size(), n);  // products with the set's own
  for (Eigen::Index k = 0; k < n; ++k) shared.col(k) = orbits.products(set.orbits[k]);
  const Eigen::VectorXd slope = orbits.slope() - shared * set.tensions;
  const Eigen::MatrixXd own = shared(set.orbits, Eigen::all);
  Eigen::MatrixXd on_own(n, orbits.size());  // coefficients in the set's own
  Eigen::VectorXd free = orbits.squares();
  if (n > 0) {
    on_own = own.ldlt().solve(shared.transpose());
    free -= shared.cwiseProduct(on_own.transpose()).rowwise().sum();
  }
  constexpr double independent = 1e-8;
  const auto first = grown.size();
  for (int j = 0; j < orbits.size(); ++j) {
    const int cables = set.cables + static_cast<int>(orbits[j].size());
    if (!(slope[j] > 0) || cables > options.max_cables ||
        !(free[j] > independent * orbits.squares()[j]))
      continue;
    const double tension = slope[j] / free[j];
    Set next{.tensions = Eigen::VectorXd::Constant(n + 1, tension),
             .rest = set.rest - tension * slope[j],
             .cables = cables};
    if (n > 0) next.tensions.head(n) = set.tensions - tension * on_own.col(j);
    if (!(next.tensions.minCoeff() > 0)) continue;
    next.orbits = set.orbits;
    next.orbits.push_back(j);
    grown.push_back(std::move(next));
  }
  // No more of one set's can stay in the beam, if none are alike.
  const auto enough = 8 * static_cast<std::size_t>(options.width);
  if (grown.size() > first + enough) {
    const auto begin = grown.begin() + static_cast<std::ptrdiff_t>(first);
    std::ranges::nth_element(begin, begin + static_cast<std::ptrdiff_t>(enough), grown.end(), {},
                             &Set::rest);
    grown.resize(first + enough);
  }
}

std::vector<Set> best_of(std::vector<Set> grown, const Orbits& orbits,
                         const equilibrium::System& system, int width) {
  std::ranges::sort(grown, {}, [](const Set& set) { return std::tie(set.rest, set.orbits); });
  std::set<Signature> seen;
  std::vector<Set> best;
  for (Set& set : grown) {
    if (!seen.insert(signature_of(set, orbits, system)).second) continue;
    best.push_back(std::move(set));
    if (static_cast<int>(best.size()) == width) break;
  }
  return best;
}

Network network_of(const Set& set, const Orbits& orbits, Network network, double rest_ratio) {
  for (std::size_t i = 0; i < set.orbits.size(); ++i)
    for (auto& cable :
         cables_of(orbits[set.orbits[i]], set.tensions[static_cast<Eigen::Index>(i)], rest_ratio))
      network.structure.cables.push_back(cable);
  return network;
}

// The network that ends closest to the target, for each number of cables.
class Closest {
 public:
  void add(Network network, double percent) {
    auto& known = found_[cable_count(network)];
    if (percent < known.percent) known = {percent, std::move(network)};
  }
  std::vector<Network> take() {
    std::vector<Network> networks;
    for (auto& [cables, found] : found_) networks.push_back(std::move(found.network));
    return networks;
  }

 private:
  struct Found {
    double percent = std::numeric_limits<double>::infinity();
    Network network{};
  };
  std::map<int, Found> found_;
};

// Where a set is not stable at the target, its equilibrium is not near it.
bool stable_at_start(const equilibrium::System& system, const Network& network) {
  equilibrium::Linearisation at;
  equilibrium::linearise(system, network.state, at);
  return at.negative <= 0;
}

}  // namespace

void BeamSearchOptions::validate() const {
  core::require(max_cables > 0, "BeamSearchOptions::max_cables must be positive");
  core::require(width > 0, "BeamSearchOptions::width must be positive");
  core::require(rounds > 0, "BeamSearchOptions::rounds must be positive");
  core::require(solved > 0, "BeamSearchOptions::solved must be positive");
  core::require(max_iterations > 0, "BeamSearchOptions::max_iterations must be positive");
  core::require(max_path_rotation > 0, "BeamSearchOptions::max_path_rotation must be positive");
  core::require(max_error_percent > 0, "BeamSearchOptions::max_error_percent must be positive");
  core::require(max_candidates > 0, "BeamSearchOptions::max_candidates must be positive");
  core::require(rest_ratio > 0 && rest_ratio < 1,
                "BeamSearchOptions::rest_ratio must be between 0 and 1");
}

std::vector<Network> beam_search(const Problem& problem, const symmetry::Group& symmetry,
                                 const BeamSearchOptions& options, const network::Control& control,
                                 network::SolveCounts& counts) {
  options.validate();
  const Network bare = problem.bare();
  const equilibrium::System system(bare.structure);
  auto candidates = some_of(candidate_orbits(system, bare.state, problem.candidates, &symmetry),
                            options.max_candidates);
  auto moved = displacements(system, bare.state, candidates);
  if (!moved) return {};
  Orbits orbits(std::move(candidates), std::move(*moved));
  Closest closest;
  std::vector<Set> beam{{.rest = orbits.goal()}};
  for (int round = 0; round < options.rounds && !beam.empty() && !control.stop.stop_requested();
       ++round) {
    std::vector<Set> grown;
    for (const Set& set : beam) grow(set, orbits, options, grown);
    beam = best_of(std::move(grown), orbits, system, options.width);
    int solved_for = 0;
    for (std::size_t k = 0; k < beam.size() && solved_for < options.solved; ++k) {
      Network network = network_of(beam[k], orbits, bare, options.rest_ratio);
      const equilibrium::System with_cables(network.structure);
      if (!stable_at_start(with_cables, network)) continue;
      ++solved_for;
      auto solved = equilibrium::solve(with_cables, network.state,
                                       {.tolerance = 1e-9,
                                        .max_iterations = options.max_iterations,
                                        .max_path_rotation = options.max_path_rotation,
                                        .stop = control.stop});
      counts += {.solves = 1, .iterations = solved.iterations};
      network.state = std::move(solved.state);
      if (!solved.usable() || !idle_cables(network).empty()) continue;
      const double percent = sensitivity::deviation(problem.target, network.state).max_percent;
      if (percent < options.max_error_percent) closest.add(std::move(network), percent);
    }
  }
  return closest.take();
}

}  // namespace tencer::ground_structure
