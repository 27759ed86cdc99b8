#include <algorithm>
#include <chrono>
#include <optional>
#include <tencer/equilibrium/path.hpp>
#include <tencer/model/scaling.hpp>
#include <tencer/model/subdivision.hpp>
#include <tencer/network/network.hpp>
#include <tencer/pipeline/design_state.hpp>
#include <tencer/pipeline/simulate.hpp>
#include <tencer/sensitivity/distance.hpp>
#include <utility>

#include "record.hpp"

namespace tencer::pipeline {
namespace {

// Largest distance of every `stride`-th vertex from `from` in % of the target's diagonal, aligned
// as the target is.
double moved_percent(const model::Target& target, std::vector<Eigen::Matrix3Xd> from,
                     const model::State& to, int stride) {
  model::Target other = target;
  other.weights.clear();
  for (const auto& points : from) {
    auto& weights = other.weights.emplace_back(Eigen::VectorXd::Zero(points.cols()));
    for (Eigen::Index i = 0; i < points.cols(); i += stride) weights[i] = 1;
  }
  other.points = std::move(from);
  return 100 * sensitivity::deviation(other, to).max / model::diagonal(target);
}

// A cable that cannot be taken as asked.
std::optional<core::Error> check_stiffness(const model::Design& design, Cables cables) {
  if (cables == Cables::inextensible) return std::nullopt;
  for (std::size_t c = 0; c < design.structure.cables.size(); ++c)
    if (!(design.structure.cables[c].stiffness > 0))
      return core::Error{"cables[" + std::to_string(c) + "]",
                         "has no stiffness and rest_length to be a spring; give it both, or take "
                         "the cables as inextensible"};
  return std::nullopt;
}

// A cable whose ends meet. structure: scaled, so that its rods' total length is 1.
std::optional<core::Error> check_spans(const model::Structure& structure,
                                       const model::State& start) {
  constexpr double meeting = 1e-12;
  const Eigen::VectorXd lengths = network::cable_lengths({structure, start});
  for (Eigen::Index c = 0; c < lengths.size(); ++c)
    if (lengths[c] <= meeting)
      return core::Error{"cables[" + std::to_string(c) + "]",
                         "its ends are the same point at the start, so it has no direction; move "
                         "one of them"};
  return std::nullopt;
}

// The cables' tensions in the design's pose; none where it does not tell any.
std::optional<Eigen::VectorXd> tensions_of(const model::Design& design,
                                           const model::Scaling& scaling) {
  Eigen::VectorXd tensions(static_cast<Eigen::Index>(design.built.size()));
  for (Eigen::Index c = 0; c < tensions.size(); ++c)
    tensions[c] =
        std::max(0.0, design.built[static_cast<std::size_t>(c)].tension) / scaling.scale.force();
  if (tensions.size() == 0 || tensions.maxCoeff() == 0) return std::nullopt;
  return tensions;
}

struct Rest {
  equilibrium::Equilibrium equilibrium{};
  Eigen::VectorXd tensions{};
  std::optional<double> fold_at = std::nullopt;
};

// From the pose `tensions` are what balances it, as far as they are known.
Rest relax(const model::Structure& structure, model::State start,
           const std::optional<Eigen::VectorXd>& tensions, const SimulateOptions& options) {
  if (options.cables == Cables::springs) {
    const equilibrium::System system(structure);
    auto found = equilibrium::solve(system, std::move(start), options.solve);
    Eigen::VectorXd pulling = system.internal_forces(found.state).tension;
    return {std::move(found), std::move(pulling)};
  }
  // Without cables nothing changes along a path.
  if (options.start == Start::target || structure.cables.empty()) {
    auto found = equilibrium::relax_inextensible(structure, std::move(start), options.solve);
    return {std::move(found.equilibrium), std::move(found.tensions)};
  }
  auto found =
      equilibrium::settle_along(structure, std::move(start), tensions, {.solve = options.solve});
  return {std::move(found.rest.equilibrium), std::move(found.rest.tensions), found.fold_at};
}

}  // namespace

void SimulateOptions::validate() const {
  core::require(refine >= 1, "SimulateOptions::refine must be at least 1");
}

core::Expected<Simulation> simulate(const model::Design& given, const SimulateOptions& options) {
  options.validate();
  model::Design design = model::subdivided(given, options.refine);
  design.check.reset();  // of another pose
  if (auto error = check_stiffness(design, options.cables)) return *error;
  const auto begin = std::chrono::steady_clock::now();
  const model::Scaling scaling = model::scaling_of(design.structure, design.target);
  const model::Structure structure = model::scaled(
      options.cables == Cables::springs ? design.structure : model::as_built(design), scaling);
  auto target = model::make_target(structure, model::scaled(design.target, scaling));
  target.views = design.views;
  const model::State start = options.start == Start::pose
                                 ? pose_state(design, structure, scaling)
                                 : target_state(design, structure, scaling);
  if (auto error = check_spans(structure, start)) return *error;

  const Rest rest = relax(structure, start, tensions_of(design, scaling), options);
  const equilibrium::Equilibrium& found = rest.equilibrium;
  Simulation simulation{
      .design = design,
      .reason = found.reason,
      .unknowns = equilibrium::System(structure).size(),
      .iterations = found.iterations,
      .factorisations = found.factorisations,
      .seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count(),
      .residual = found.residual,
      .moved_percent =
          moved_percent(target, model::scaled(design.pose, scaling), found.state, options.refine),
      .fold_at = rest.fold_at};
  record({structure, found.state, rest.tensions, target}, scaling, simulation.design);
  if (!simulation.stays())
    simulation.design.status = found.reason == equilibrium::Reason::stopped
                                   ? model::DesignStatus::interrupted
                                   : model::DesignStatus::tolerance_not_reached;
  return simulation;
}

}  // namespace tencer::pipeline
