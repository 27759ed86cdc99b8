#include <algorithm>
#include <cmath>
#include <numbers>
#include <tencer/core/error.hpp>
#include <tencer/equilibrium/solve.hpp>
#include <tencer/ground_structure/feasibility.hpp>
#include <tencer/sensitivity/distance.hpp>
#include <utility>

namespace tencer::ground_structure {
namespace {

// The start moved by smooth waves of a hundred-thousandth of the rods' length: it bends no edge,
// and leaves a balance by symmetry alone.
model::State shaken(const equilibrium::System& bare, const model::State& start) {
  constexpr double size = 1e-5;
  model::State state = start;
  Eigen::VectorXd step = Eigen::VectorXd::Zero(bare.size());
  for (int r = 0; r < static_cast<int>(start.size()); ++r) {
    const geometry::ArcLength& arc = bare.arc_lengths()[r];
    for (int v = 0; v < bare.structure().rods[r].vertices(); ++v)
      for (int axis = 0; axis < 3; ++axis) {
        const int at = bare.position_index(r, v, axis);
        if (at < 0) continue;
        const double turn = 2 * std::numbers::pi * arc.knots()[v] / arc.length();
        for (int wave = 1; wave <= 4; ++wave)
          step[at] += size / wave * std::sin(wave * turn + 1.7 * axis + 0.9 * wave + 2.3 * r);
      }
  }
  bare.displace(state, step);
  return state;
}

// The candidates as cables that are as long as they are at the target.
std::vector<springs::Cable> tied_cables(const std::vector<CandidateOrbit>& candidates) {
  std::vector<springs::Cable> cables;
  for (const CandidateOrbit& orbit : candidates)
    for (const CandidateColumn& column : orbit) {
      cables.push_back(column.cable);
      cables.back().rest_length = column.length;
    }
  return cables;
}

// Per cable, by how much a state lengthens it, relative to its length.
Eigen::VectorXd lengthening(const equilibrium::System& all, const model::State& state) {
  const auto& cables = all.structure().cables;
  Eigen::VectorXd result(static_cast<Eigen::Index>(cables.size()));
  for (std::size_t c = 0; c < cables.size(); ++c)
    result[static_cast<Eigen::Index>(c)] =
        model::span_of(all.stencils()[c], state).norm() / cables[c].rest_length - 1;
  return result;
}

// The cables that are lengthened most and not tied yet.
std::vector<int> most_lengthened(const Eigen::VectorXd& lengthening, const std::vector<int>& tied,
                                 std::size_t most) {
  std::vector<bool> already(static_cast<std::size_t>(lengthening.size()), false);
  for (const int c : tied) already[c] = true;
  std::vector<int> found;
  for (int c = 0; c < lengthening.size(); ++c)
    if (!already[c] && lengthening[c] > TiedRest::allowed_lengthening) found.push_back(c);
  std::ranges::sort(found, [&](int a, int b) {
    return lengthening[a] != lengthening[b] ? lengthening[a] > lengthening[b] : a < b;
  });
  if (found.size() > most) found.resize(most);
  return found;
}

// Newton's method from one start with more and more of the candidates tied.
class Tying {
 public:
  Tying(const Problem& problem, const std::vector<CandidateOrbit>& candidates,
        const Relaxation& first, const TiedRestOptions& options)
      : problem_(problem),
        first_(first),
        options_(options),
        bare_(problem.structure),
        all_(with_cables(problem.structure, tied_cables(candidates))),
        start_(shaken(bare_, problem.start)),
        energy_(bare_.energy(problem.start)) {
    for (const auto& rod : problem.structure.rods)
      stiffness_ = std::max(stiffness_, cable_part * rod.section.EA);
  }

  TiedRest run() {
    constexpr int max_rounds = 12;
    constexpr double allowed = TiedRest::allowed_lengthening;
    TiedRest result{.tied = first_.tensions.set};
    for (int round = 0; round < max_rounds; ++round) {
      const Eigen::VectorXd longer = settle(start_, options_.max_iterations / 4, result);
      const bool near = result.rests && result.max_percent <= options_.near_percent;
      const auto more =
          most_lengthened(longer, result.tied, std::max<std::size_t>(100, result.tied.size()));
      const bool done = more.empty() && result.proves_motion();
      if (near || done || iterations_ >= options_.max_iterations || options_.stop.stop_requested())
        break;
      // Springs that are stretched, or that have driven the rods by what they store.
      const bool stretched =
          std::ranges::any_of(result.tied, [&](int c) { return longer[c] > allowed; });
      if (result.rests && (stretched || result.released < 0)) stiffness_ *= 4;
      result.tied.insert(result.tied.end(), more.begin(), more.end());
    }
    // Given up on the way, it may be between two steps that lower the energy together.
    const bool near = result.rests && result.max_percent <= options_.near_percent;
    if (!near && !result.rests && !result.proves_motion() && !options_.stop.stop_requested())
      settle(model::State(result.state), options_.max_iterations / 2, result);
    return result;
  }

 private:
  // Of the rods' axial stiffness: that of a cable, to begin with.
  static constexpr double cable_part = 0.1;

  static model::Structure with_cables(model::Structure structure,
                                      std::vector<springs::Cable> cables) {
    structure.cables = std::move(cables);
    return structure;
  }

  // The cables tied so far: those of the balance pull at the target with what it found, all others
  // are just taut there.
  std::vector<springs::Cable> springs(const std::vector<int>& tied) const {
    std::vector<springs::Cable> cables;
    for (std::size_t i = 0; i < tied.size(); ++i) {
      springs::Cable cable = all_.structure().cables[tied[i]];
      cable.tension_only = true;
      cable.stiffness = stiffness_ / cable.rest_length;
      if (i < first_.tensions.set.size())
        cable.rest_length =
            std::max(0.0, cable.rest_length - first_.tensions.values[static_cast<Eigen::Index>(i)] /
                                                  cable.stiffness);
      cables.push_back(std::move(cable));
    }
    return cables;
  }

  // Where the rods come to rest from there with result.tied, into the result; by how much all
  // candidates are longer there.
  Eigen::VectorXd settle(model::State from, int iterations, TiedRest& result) {
    auto cables = problem_.structure.cables;
    for (auto& cable : springs(result.tied)) cables.push_back(std::move(cable));
    const equilibrium::System system(with_cables(problem_.structure, std::move(cables)));
    auto rest = equilibrium::solve(
        system, std::move(from),
        {.tolerance = 1e-8, .max_iterations = std::max(1, iterations), .stop = options_.stop},
        workspace_);
    iterations_ += rest.iterations;
    result.rests = rest.usable() || rest.reason == equilibrium::Reason::neutral ||
                   rest.reason == equilibrium::Reason::uncertain;
    result.state = std::move(rest.state);
    result.tensions = system.internal_forces(result.state)
                          .tension.tail(static_cast<Eigen::Index>(result.tied.size()));
    result.max_percent = sensitivity::deviation(problem_.target, result.state).max_percent;
    const double released = energy_ - bare_.energy(result.state);
    result.released = energy_ != 0 ? released / std::abs(energy_) : 0;
    Eigen::VectorXd longer = lengthening(all_, result.state);
    result.lengthening = longer.size() > 0 ? std::max(0.0, longer.maxCoeff()) : 0;
    return longer;
  }

  const Problem& problem_;
  const Relaxation& first_;
  const TiedRestOptions& options_;
  equilibrium::System bare_;
  equilibrium::System all_;  // with every candidate alone, its rest length that at the target
  model::State start_;
  double energy_;
  double stiffness_ = 0;
  equilibrium::Linearisation workspace_;
  int iterations_ = 0;
};

}  // namespace

void TiedRestOptions::validate() const {
  core::require(near_percent >= 0, "TiedRestOptions::near_percent must not be negative");
  core::require(max_iterations > 0, "TiedRestOptions::max_iterations must be positive");
}

TiedRest tied_rest(const Problem& problem, const std::vector<CandidateOrbit>& candidates,
                   const Relaxation& first, const TiedRestOptions& options) {
  options.validate();
  return Tying(problem, candidates, first, options).run();
}

}  // namespace tencer::ground_structure
