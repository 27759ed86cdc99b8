#include <chrono>
#include <tencer/equilibrium/built.hpp>
#include <tencer/geometry/measure.hpp>
#include <tencer/pipeline/refine.hpp>
#include <tencer/pipeline/simulate.hpp>
#include <utility>

#include "record.hpp"

namespace tencer::pipeline {
namespace {

constexpr double meeting = 1e-12;  // relative to the rods' total length

// Largest distance of every `stride`-th vertex from `from` in % of the target's diagonal, aligned
// as the target is.
double moved_percent(const sensitivity::Target& target, std::vector<Eigen::Matrix3Xd> from,
                     const equilibrium::State& to, int stride) {
  std::vector<geometry::Polyline> curves;
  for (const auto& points : target.points) curves.push_back({.points = points});
  sensitivity::Target other = target;
  other.weights.clear();
  for (const auto& points : from) {
    auto& weights = other.weights.emplace_back(Eigen::VectorXd::Zero(points.cols()));
    for (Eigen::Index i = 0; i < points.cols(); i += stride) weights[i] = 1;
  }
  other.points = std::move(from);
  return 100 * sensitivity::deviation(other, to).max / geometry::bounding_box_diagonal(curves);
}

}  // namespace

core::Expected<Simulation> simulate(const io::Design& given, const SimulateOptions& options) {
  const io::Design design = refined(given, options.refine);
  if (options.cables == Cables::springs)
    for (std::size_t c = 0; c < design.cables.size(); ++c)
      if (!design.cables[c].stiffness || !design.cables[c].rest_length)
        return core::Error{"cables[" + std::to_string(c) + "]",
                           "has no stiffness and rest_length to be a spring; give it both, or take "
                           "the cables as inextensible"};
  const auto begin = std::chrono::steady_clock::now();
  const Units units = units_of(design);
  const equilibrium::Structure structure = structure_of(design, options.cables, units);
  const auto target = target_of(structure, scaled_targets(design, units));
  const auto poses = scaled_poses(design, units);
  equilibrium::State start = options.start == Start::pose ? pose_state(design, structure, units)
                                                          : target_state(design, structure, units);

  const equilibrium::System cables(structure);
  for (std::size_t c = 0; c < structure.cables.size(); ++c)
    if (equilibrium::span_of(cables.stencils()[c], start).norm() <= meeting)
      return core::Error{"cables[" + std::to_string(c) + "]",
                         "its ends are the same point at the start, so it has no direction; move "
                         "one of them"};

  Simulation simulation{.design = design};
  equilibrium::Equilibrium found;
  Eigen::VectorXd tensions;
  if (options.cables == Cables::springs) {
    const equilibrium::System system(structure);
    found = equilibrium::solve(system, std::move(start), options.solve);
    tensions = system.internal_forces(found.state).tension;
  } else {
    equilibrium::BuiltForm built = equilibrium::settle(structure, std::move(start), options.solve);
    found = std::move(built.equilibrium);
    tensions = std::move(built.tensions);
  }
  simulation.seconds =
      std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  simulation.reason = found.reason;
  simulation.unknowns = equilibrium::System(structure).size();
  simulation.iterations = found.iterations;
  simulation.factorisations = found.factorisations;
  simulation.residual = found.residual;
  simulation.moved_percent = moved_percent(target, poses, found.state, options.refine);
  record(structure, found.state, tensions, target, units, simulation.design);
  if (!simulation.usable())
    simulation.design.status = found.reason == equilibrium::Reason::stopped
                                   ? io::DesignStatus::interrupted
                                   : io::DesignStatus::tolerance_not_reached;
  return simulation;
}

}  // namespace tencer::pipeline
