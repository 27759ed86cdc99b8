#include <cmath>
#include <tencer/model/units.hpp>
#include <tencer/pipeline/check.hpp>
#include <tencer/pipeline/design_state.hpp>
#include <tencer/pipeline/simulate.hpp>

#include "check/pose.hpp"
#include "check/repair.hpp"

namespace tencer::pipeline {

void CheckOptions::validate() const {
  const auto error = [](double value) { return value >= 0 && std::isfinite(value); };
  core::require(error(length_error_mm), "CheckOptions::length_error_mm must not be negative");
  core::require(error(attachment_error_mm),
                "CheckOptions::attachment_error_mm must not be negative");
  if (const auto wrong = max_deviation.problem())
    throw std::invalid_argument("CheckOptions::max_deviation " + *wrong);
  core::require(breaking_load_newtons > 0 && std::isfinite(breaking_load_newtons),
                "CheckOptions::breaking_load_newtons must be positive");
  core::require(draws >= 1, "CheckOptions::draws must be at least 1");
  core::require(most_times >= 1, "CheckOptions::most_times must be at least 1");
}

RestPose rest_pose(const model::Design& design) {
  RestPose pose{.design = design,
                .scaling = model::scaling_of(design.structure, design.target),
                .structure = {},
                .state = {},
                .tensions = Eigen::VectorXd(static_cast<Eigen::Index>(design.built.size()))};
  pose.structure = model::scaled(model::as_built(design), pose.scaling);
  pose.state = pose_state(design, pose.structure, pose.scaling);
  for (Eigen::Index c = 0; c < pose.tensions.size(); ++c)
    pose.tensions[c] = design.built[c].tension / pose.scaling.scale.force();
  return pose;
}

double millimetre_of(const model::Design& design) {
  return 1e-3 / model::metres(design.length_unit);
}

double size_of(const model::Design& design) {
  return model::diagonal(model::make_target(design.structure, design.target));
}

model::Check quick_check(const model::Design& design, const CheckOptions& options) {
  options.validate();
  const RestPose pose = rest_pose(design);
  return {.forgives = forgives_enough(pose, options),
          .weight = own_weight(pose, options),
          .clear = clear(pose),
          .converged = converged(design, options)};
}

std::optional<model::Forgives> forgiven_errors(const model::Design& design,
                                               const CheckOptions& options) {
  options.validate();
  return forgives(rest_pose(design), options);
}

namespace {

core::Expected<Checked> check_repaired(Repaired repaired, CheckOptions options) {
  options.repair = false;
  auto result = check(repaired.design, options);
  if (result) result->check.repair = std::move(repaired.repair);
  return result;
}

}  // namespace

core::Expected<Checked> check(const model::Design& design, const CheckOptions& options) {
  options.validate();
  const auto rest = simulate(design, {.solve = {.stop = options.stop}});
  if (!rest) return rest.error();
  Checked result{.design = rest->design};
  const RestPose pose = rest_pose(rest->design);
  model::Check& found = result.check;
  found.stands = stands(pose, rest->moved_percent / 100 * size_of(design));
  found.stands->rests = rest->usable();
  if (!rest->usable()) return result;
  if (options.repair) {
    auto repaired = found.stands->free_groups.empty()
                        ? Repaired{}
                        : repair(pose, found.stands->allowed, options);
    if (repaired.repair.cables > 0) return check_repaired(std::move(repaired), options);
    found.repair = std::move(repaired.repair);
  }
  found.forgives = forgives(pose, options);
  // What moves at no cost stays where it is pushed.
  if (found.stands->free_groups.empty()) found.comes_back = comes_back(pose, options);
  found.holds = holds(pose, options);
  found.weight = own_weight(pose, options);
  found.clear = clear(pose);
  found.converged = converged(rest->design, options);
  return result;
}

}  // namespace tencer::pipeline
