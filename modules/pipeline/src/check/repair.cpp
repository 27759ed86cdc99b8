#include "check/repair.hpp"

#include <algorithm>
#include <span>
#include <tencer/certify/free_motions.hpp>
#include <tencer/core/names.hpp>
#include <tencer/ground_structure/candidates.hpp>
#include <tencer/ground_structure/feasibility.hpp>
#include <tencer/ground_structure/force_balance.hpp>
#include <tencer/network/rest_length.hpp>
#include <tencer/pipeline/simulate.hpp>
#include <tencer/springs/law.hpp>

namespace tencer::pipeline {
namespace {

using Cables = std::vector<springs::Cable>;

// The structure at rest, its cables as springs that pull as they do.
model::Structure springs_of(const RestPose& pose) {
  model::Structure structure = pose.structure;
  const Eigen::VectorXd lengths = network::cable_lengths({structure, pose.state});
  for (Eigen::Index c = 0; c < lengths.size(); ++c) {
    auto& cable = structure.cables[static_cast<std::size_t>(c)];
    cable = springs::with_tension(cable, lengths[c], pose.tensions[c], network::stiff_rest_ratio);
  }
  return structure;
}

// A repaired design.
struct Found {
  Simulation rest{};
  double tension = 1.0;  // see Way
  // It forgives errors, to first order, all cables pull well, and it stands with finer rods too.
  bool good = false;

  int cables() const { return static_cast<int>(rest.design.structure.cables.size()); }
};

// How ties are looked for.
struct Way {
  double tension = 1.0;  // of the first of them, relative to the design's cables
  int ties = 1;          // so many are set, the others balance them
  double percent = 0.1;  // of the size: to which they do
};

// Looks for cables to tie what is loose.
class Ties {
 public:
  Ties(const RestPose& pose, double allowed, const CheckOptions& options)
      : pose_(pose), allowed_(allowed), options_(options) {
    problem_.structure = springs_of(pose);
    problem_.start = pose.state;
    problem_.target = model::make_target(problem_.structure, model::positions_of(pose.state));
    // In the plane cables lie in another layer than rods.
    if (!problem_.structure.planar) problem_.rules.gaps = model::Gaps{};
  }

  core::Expected<Cables> candidates() const {
    return ground_structure::candidates(problem_.structure, problem_.target.points, problem_.rules);
  }

  // Rods that cables only draw to others, in words; empty: there are none.
  std::string apart(const Cables& candidates) const {
    const auto orbits = ground_structure::candidate_orbits(equilibrium::System(problem_.structure),
                                                           problem_.start, candidates, nullptr);
    const auto found = ground_structure::separation(problem_, orbits);
    if (!found) return {};
    return "every cable that could tie " +
           core::rods_in_words(found->rods, pose_.structure.rods.size()) +
           " to anything draws it there, and none keeps it away";
  }

  // With the fewest of the candidates; good ones first. Less tension where the full one moves it
  // too far.
  std::optional<Found> among(const Cables& candidates) {
    problem_.candidates = candidates;
    std::optional<Found> best;
    for (const double tension : {1.0, 0.3, 0.1}) {
      for (const double percent : {1.0, 0.3, 0.1})
        if (auto next = best_of(tension, percent); next && (!best || better(*next, *best)))
          best = std::move(next);
      if (best && best->good) break;
    }
    return best;
  }

  // With fewer of its added cables, as long as the others can do without one of them.
  Found without_idle(Found best) {
    for (bool fewer = true; fewer;) {
      fewer = false;
      const model::Structure now = model::scaled(best.rest.design.structure, pose_.scaling);
      const Cables added(now.cables.begin() + own_cables(), now.cables.end());
      for (std::size_t left_out = 0; left_out < added.size() && added.size() > 1; ++left_out) {
        problem_.candidates = added;
        problem_.candidates.erase(problem_.candidates.begin() +
                                  static_cast<std::ptrdiff_t>(left_out));
        auto next = best_of(best.tension, 1.0);
        if (!next || !better(*next, best) || next->cables() == best.cables()) continue;
        best = std::move(*next);
        fewer = true;
      }
    }
    return best;
  }

  int own_cables() const { return static_cast<int>(pose_.structure.cables.size()); }

 private:
  static constexpr double weakest = 0.01;  // of the strongest cable's tension

  static bool better(const Found& one, const Found& other) {
    return one.good == other.good ? one.cables() < other.cables() : one.good;
  }

  std::optional<Found> best_of(double tension, double percent) const {
    std::optional<Found> best;
    for (const int ties : {1, 2, 3}) {
      if (options_.stop.stop_requested()) break;
      auto next = tied({tension, ties, percent});
      if (next && (!best || better(*next, *best))) best = std::move(next);
    }
    return best;
  }

  // Not set: it does not stand so, or is moved too far.
  std::optional<Found> tied(const Way& way) const {
    const double own = own_cables() > 0 ? pose_.tensions.mean() : 1.0;
    // Whatever is as stiff as the design is stiff enough.
    const double margin =
        std::clamp(0.5 * pose_.design.certificate->smallest_eigenvalue, 1.0, 5000.0);
    const auto stage = ground_structure::force_balance(problem_, nullptr,
                                                       {.max_error_percent = way.percent,
                                                        .stability_margin = margin,
                                                        .ties = way.ties,
                                                        .tie_tension = way.tension * own},
                                                       {.stop = options_.stop});
    const model::Design design = with_cables(stage.network);
    if (!stage.valid() || design.built.size() == pose_.design.built.size()) return std::nullopt;
    auto rest = simulate(design, {.solve = {.stop = options_.stop}});
    if (!rest || !stands(*rest)) return std::nullopt;
    CheckOptions quick = options_;
    quick.draws = 1000;
    const auto tolerated = forgives_linearly(rest_pose(rest->design), quick);
    const auto [least, most] =
        std::ranges::minmax(rest->design.built, {}, &model::BuiltCable::tension);
    const bool pulls = least.tension >= weakest * most.tension;
    const bool forgives = tolerated && tolerated->percentile_95 <= tolerated->max_deviation;
    Found found{.rest = std::move(*rest), .tension = way.tension};
    if (!pulls || !forgives) return found;
    const auto finer = simulate(found.rest.design, {.refine = 2, .solve = {.stop = options_.stop}});
    found.good = finer && finer->stays();
    return found;
  }

  // The design with the cables that the network has beside its own, those between the same places
  // as one.
  model::Design with_cables(const network::Network& network) const {
    model::Design design = pose_.design;
    const Eigen::VectorXd lengths = network::cable_lengths(network);
    const Eigen::VectorXd tensions = network::cable_tensions(network);
    auto& cables = design.structure.cables;
    for (Eigen::Index c = own_cables(); c < lengths.size(); ++c) {
      const springs::Cable cable = model::unscaled(
          network.structure.cables[static_cast<std::size_t>(c)], network.structure, pose_.scaling);
      const double tension = tensions[c] * pose_.scaling.scale.force();
      const auto same = std::ranges::find(cables.begin() + own_cables(), cables.end(),
                                          springs::describe(cable), springs::describe);
      if (same != cables.end()) {
        same->stiffness += cable.stiffness;
        design.built[same - cables.begin()].tension += tension;
        continue;
      }
      cables.push_back(cable);
      design.built.push_back(
          {.length = lengths[c] * pose_.scaling.scale.length, .tension = tension});
    }
    return design;
  }

  // Certified, near the pose, and nothing moves at no cost.
  bool stands(const Simulation& rest) const {
    const model::Design& design = rest.design;
    if (!rest.stays() || !design.certificate->stable) return false;
    if (rest.moved_percent / 100 * size_of(design) > allowed_) return false;
    const RestPose at_rest = rest_pose(design);
    return certify::free_groups(at_rest.structure, at_rest.state).empty();
  }

  const RestPose& pose_;
  double allowed_;
  const CheckOptions& options_;
  ground_structure::Problem problem_{};
};

}  // namespace

Repaired repair(const RestPose& pose, double allowed, const CheckOptions& options) {
  const auto cannot = [](std::string why) {
    return Repaired{.repair = {.problem = std::move(why)}};
  };
  if (pose.design.certificate->slack_cables > 0)
    return cannot("cables that are slack hold nothing to tie others to");
  Ties ties(pose, allowed, options);
  const auto candidates = ties.candidates();
  if (!candidates) return cannot(candidates.error().text());
  if (std::string why = ties.apart(*candidates); !why.empty()) return cannot(std::move(why));
  auto found = ties.among(*candidates);
  if (!found)
    return cannot(
        "no cables were found between rods, or to anchors, with which it stands where it is");
  const Found best = ties.without_idle(std::move(*found));
  const model::Design& design = best.rest.design;
  const int first = ties.own_cables();
  const auto [least, most] =
      std::ranges::minmax(std::span(design.built).subspan(static_cast<std::size_t>(first)), {},
                          &model::BuiltCable::tension);
  return {.repair = {.cables = best.cables() - first,
                     .first_cable = first,
                     .least_tension = least.tension,
                     .most_tension = most.tension,
                     .moved = best.rest.moved_percent / 100 * size_of(design)},
          .design = design};
}

}  // namespace tencer::pipeline
