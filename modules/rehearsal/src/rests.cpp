#include <optional>
#include <tencer/model/target.hpp>
#include <tencer/rehearsal/actuate.hpp>
#include <tencer/rehearsal/rests.hpp>
#include <tencer/sensitivity/distance.hpp>
#include <utility>

#include "resting.hpp"

namespace tencer::rehearsal {
namespace {

DesignRest rest_of(const Resting& start, const motion::Rest& rest) {
  const core::Scale& scale = start.scaling.scale;
  const model::Design& design = start.design;
  const auto off = sensitivity::deviation(
      model::make_target(start.structure, model::scaled(design.target, start.scaling)), rest.state);
  DesignRest result{.design = design,
                    .energy = rest.energy * scale.energy,
                    .softest = rest.softest,
                    .off_target = off.max * scale.length,
                    .away = rest.away * scale.length,
                    .found = rest.found};
  Fitted fit = fitted(start, rest.state, design.pose);
  const Eigen::VectorXd lengths = model::cable_lengths(start.structure, rest.state);
  std::vector<model::BuiltCable> built;
  for (Eigen::Index c = 0; c < lengths.size(); ++c) {
    const bool taut = rest.tensions[c] > 0;
    built.push_back({.length = taut ? lengths[c] * scale.length
                                    : design.built[static_cast<std::size_t>(c)].length,
                     .tension = rest.tensions[c] * scale.force()});
  }
  result.design = in_pose(design, {.pose = std::move(fit.pose),
                                   .pose_directors = std::move(fit.directors),
                                   .built = std::move(built)});
  return result;
}

DesignPass pass_of(const Resting& start, const motion::Pass& pass) {
  const core::Scale& scale = start.scaling.scale;
  DesignPass result{.from = pass.from,
                    .to = pass.to,
                    .energy = pass.energy * scale.energy,
                    .top = pass.top,
                    .strands_apart = pass.strands_apart * scale.length,
                    .strands_met = pass.strands_met,
                    .cable_in_rod = pass.cable_in_rod};
  for (const motion::WayPose& at : pass.way) {
    const auto& before = result.way.empty() ? start.design.pose : result.way.back();
    result.way.push_back(fitted(start, at.state, before).pose);
    result.energies.push_back(at.energy * scale.energy);
  }
  return result;
}

}  // namespace

core::Expected<DesignRests> rests(const model::Design& design,
                                  const motion::RestsOptions& options) {
  const std::optional<Resting> start = resting(design, options.stop);
  if (!start)
    return core::Error{design.name,
                       "the design does not rest in its pose, so there is none to push it out of; "
                       "tencer simulate -o gives one that does"};
  const auto found = motion::find_rests(start->structure, start->state, start->tensions, options);
  if (found.rests.empty())
    return core::Error{design.name,
                       "the design's pose is not certain to be stable, so there is nothing to "
                       "compare others with; tencer check says why"};
  DesignRests result{.ways = motion::lowest_ways(found, 0),
                     .pushes = found.pushes,
                     .lost = found.lost,
                     .passes_missed = found.passes_missed,
                     .finished = found.finished};
  for (const motion::Rest& rest : found.rests) result.rests.push_back(rest_of(*start, rest));
  for (const motion::Pass& pass : found.passes) result.passes.push_back(pass_of(*start, pass));
  return result;
}

}  // namespace tencer::rehearsal
