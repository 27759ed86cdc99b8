#include <algorithm>
#include <tencer/certify/draws.hpp>

#include "check/pose.hpp"

namespace tencer::pipeline {
namespace {

certify::CableErrors scaled_errors(const RestPose& pose, const model::Forgives& forgives) {
  const double unit = pose.scaling.scale.length;
  return {.length = forgives.length_error / unit, .attachment = forgives.attachment_error / unit};
}

// How some of the structures settle for good, in lengths of the design.
void settle(const RestPose& pose, const CheckOptions& options, model::Forgives& result) {
  constexpr int draws = 30;
  const certify::CableErrors errors = scaled_errors(pose, result);
  if (errors.length == 0 && errors.attachment == 0) return;
  const auto settled = certify::settle_draws(pose.structure, pose.state, pose.tensions, errors,
                                             draws, options.seed, options.stop, pose.design.views);
  for (const certify::Draw& draw : settled) {
    ++result.settled;
    const double deviation = draw.deviation * pose.scaling.scale.length;
    // Without a path a fall is told by where it ends, far beyond all that first order has.
    const bool elsewhere = !draw.followed && deviation > 1.5 * result.worst;
    if (draw.falls_at || !draw.rests || elsewhere)
      ++result.fallen;
    else
      result.settled_worst = std::max(result.settled_worst, deviation);
  }
  const auto fall = certify::first_fall(pose.structure, pose.state, pose.tensions, errors, settled,
                                        options.seed, options.most_times, options.stop);
  result.falls_at = fall.times;
  result.falls_up_to = fall.looked_to;
}

}  // namespace

std::optional<model::Forgives> forgives_linearly(const RestPose& pose,
                                                 const CheckOptions& options) {
  const double millimetre = millimetre_of(pose.design);
  const double unit = pose.scaling.scale.length;
  model::Forgives result{
      .length_error = options.length_error_mm * millimetre,
      .attachment_error = options.attachment_error_mm * millimetre,
      .max_deviation = options.max_deviation.length(pose.design.length_unit, size_of(pose.design)),
      .draws = options.draws};
  const auto response =
      certify::pose_response(pose.structure, pose.state, pose.tensions, pose.design.views);
  if (!response.computed) return std::nullopt;
  const auto found = certify::tolerance(response, pose.tensions, scaled_errors(pose, result),
                                        options.draws, options.seed);
  result.expected = found.expected * unit;
  result.percentile_95 = found.percentile_95 * unit;
  result.worst = found.worst * unit;
  result.decisive_cable = found.decisive_cable;
  result.decisive = found.decisive * unit;
  result.first_slack = found.first_slack;
  result.slack_at = found.slack_at;
  return result;
}

std::optional<model::Forgives> forgives_enough(const RestPose& pose, const CheckOptions& options) {
  auto result = forgives_linearly(pose, options);
  if (result && result->percentile_95 <= result->max_deviation) settle(pose, options, *result);
  return result;
}

std::optional<model::Forgives> forgives(const RestPose& pose, const CheckOptions& options) {
  auto result = forgives_linearly(pose, options);
  if (result) settle(pose, options, *result);
  return result;
}

}  // namespace tencer::pipeline
