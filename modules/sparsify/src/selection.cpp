#include "selection.hpp"

#include <Eigen/Cholesky>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <set>
#include <utility>

#include "target_balance.hpp"

namespace tencer::sparsify {
namespace {

constexpr int beam_width = 60;
constexpr int rounds = 6;
constexpr int solved_each = 8;    // sets of a round
constexpr double hopeless = 8;    // % from the target
constexpr double farthest = 1.0;  // turn of an edge, in radians, on the way to the equilibrium
constexpr int most_iterations = 20;
constexpr double rho = 0.99;  // rest length relative to length

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
  Orbits(std::vector<Pulls> pulls, Displacements moved)
      : pulls_(std::move(pulls)),
        columns_(std::move(moved.columns)),
        squares_(columns_.colwise().squaredNorm()),
        slope_(columns_.transpose() * moved.goal),
        goal_(moved.goal.squaredNorm()) {}

  int size() const { return static_cast<int>(pulls_.size()); }
  const Pulls& pulls(int orbit) const { return pulls_[orbit]; }
  double goal() const { return goal_; }
  // Of every orbit with itself and with the goal.
  const Eigen::VectorXd& squares() const { return squares_; }
  const Eigen::VectorXd& slope() const { return slope_; }
  // Of every orbit with this one.
  const Eigen::VectorXd& products(int orbit) {
    auto& known = products_[orbit];
    if (known.size() == 0) known = columns_.transpose() * columns_.col(orbit);
    return known;
  }

 private:
  std::vector<Pulls> pulls_;
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
  for (const int o : set.orbits) {
    const springs::Cable& cable = orbits.pulls(o).front().cable;
    auto a = place(cable.a);
    auto b = place(cable.b);
    if (b < a) std::swap(a, b);
    signature.push_back({a[0], a[1], b[0], b[1]});
  }
  std::ranges::sort(signature);
  return signature;
}

// So many of them at most, evenly spread: enough to choose from, on rods however many.
std::vector<Pulls> some_of(std::vector<Pulls> all) {
  constexpr std::size_t most = 4000;
  if (all.size() <= most) return all;
  std::vector<Pulls> some;
  for (std::size_t k = 0; k < most; ++k) some.push_back(std::move(all[k * all.size() / most]));
  return some;
}

// The sets of one orbit more: orthogonal least squares.
void grow(const Set& set, Orbits& orbits, int most, std::vector<Set>& grown) {
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
    const int cables = set.cables + static_cast<int>(orbits.pulls(j).size());
    if (!(slope[j] > 0) || cables > most || !(free[j] > independent * orbits.squares()[j]))
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
  constexpr std::size_t enough = 8 * beam_width;
  if (grown.size() > first + enough) {
    const auto begin = grown.begin() + static_cast<std::ptrdiff_t>(first);
    std::ranges::nth_element(begin, begin + enough, grown.end(), {}, &Set::rest);
    grown.resize(first + enough);
  }
}

std::vector<Set> best_of(std::vector<Set> grown, const Orbits& orbits,
                         const equilibrium::System& system) {
  std::ranges::sort(grown, {}, [](const Set& set) { return std::pair(set.rest, set.orbits); });
  std::set<Signature> seen;
  std::vector<Set> best;
  for (Set& set : grown) {
    if (!seen.insert(signature_of(set, orbits, system)).second) continue;
    best.push_back(std::move(set));
    if (best.size() == beam_width) break;
  }
  return best;
}

Network network_of(const Set& set, const Orbits& orbits, Network network) {
  for (std::size_t i = 0; i < set.orbits.size(); ++i)
    for (const Pull& pull : orbits.pulls(set.orbits[i]))
      network.structure.cables.push_back(
          cable_of(pull, set.tensions[static_cast<Eigen::Index>(i)], rho));
  return network;
}

}  // namespace

std::vector<Network> select_few(const Network& bare, const sensitivity::Target& target,
                                std::span<const springs::Cable> candidates,
                                const symmetry::Group& symmetry, int most, const Control& control,
                                Effort& effort) {
  const equilibrium::System system(bare.structure);
  auto pulls = some_of(pulls_at(system, bare.state, candidates, &symmetry));
  auto moved = displacements(system, bare.state, pulls);
  Orbits orbits(std::move(pulls), std::move(moved));
  equilibrium::Linearisation at;
  struct Found {
    double percent = std::numeric_limits<double>::infinity();
    Network network{};
  };
  std::map<int, Found> closest;  // by number of cables
  std::vector<Set> beam{{.rest = orbits.goal()}};
  for (int round = 0; round < rounds && !beam.empty() && !control.stop.stop_requested(); ++round) {
    std::vector<Set> grown;
    for (const Set& set : beam) grow(set, orbits, most, grown);
    beam = best_of(std::move(grown), orbits, system);
    int tried = 0;
    for (std::size_t k = 0; k < beam.size() && tried < solved_each; ++k) {
      Network network = network_of(beam[k], orbits, bare);
      // Where a set is not stable at the target, it is not near it.
      const equilibrium::System with(network.structure);
      equilibrium::linearise(with, network.state, at);
      if (at.negative > 0) continue;
      ++tried;
      auto solved = equilibrium::solve(with, network.state,
                                       {.tolerance = 1e-9,
                                        .max_iterations = most_iterations,
                                        .farthest = farthest,
                                        .stop = control.stop});
      ++effort.solves;
      effort.iterations += solved.iterations;
      network.state = std::move(solved.state);
      if (!solved.usable() || !idle_cables(network).empty()) continue;
      const double percent = sensitivity::deviation(target, network.state).max_percent;
      if (!(percent < hopeless)) continue;
      if (Found& known = closest[beam[k].cables]; percent < known.percent)
        known = {percent, std::move(network)};
    }
  }
  std::vector<Network> networks;
  for (auto& [cables, found] : closest) networks.push_back(std::move(found.network));
  return networks;
}

}  // namespace tencer::sparsify
