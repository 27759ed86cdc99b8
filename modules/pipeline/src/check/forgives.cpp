#include <tencer/certify/tolerance.hpp>

#include "check/pose.hpp"

namespace tencer::pipeline {

std::optional<model::Forgives> forgives(const RestPose& pose, const CheckOptions& options) {
  const double millimetre = millimetre_of(pose.design);
  const double unit = pose.scaling.scale.length;
  model::Forgives result{.length_error = options.length_error_mm * millimetre,
                         .attachment_error = options.attachment_error_mm * millimetre,
                         .max_deviation = options.max_deviation_mm
                                              ? *options.max_deviation_mm * millimetre
                                              : 0.01 * size_of(pose.design),
                         .draws = options.draws};
  const auto response = certify::pose_response(pose.structure, pose.state, pose.tensions);
  if (!response.computed) return std::nullopt;
  const auto found = certify::tolerance(
      response, pose.tensions,
      {.length = result.length_error / unit, .attachment = result.attachment_error / unit},
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

}  // namespace tencer::pipeline
