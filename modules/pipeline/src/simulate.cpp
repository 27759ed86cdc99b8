#include <chrono>
#include <tencer/equilibrium/built.hpp>
#include <tencer/pipeline/simulate.hpp>
#include <utility>

#include "record.hpp"

namespace tencer::pipeline {
namespace {

constexpr double meeting = 1e-12;  // relative to the rods' total length

// Largest distance between two states in % of the target's diagonal, aligned as the target is.
double moved_percent(const sensitivity::Target& target, std::vector<Eigen::Matrix3Xd> from,
                     const equilibrium::State& to) {
  sensitivity::Target other = target;
  const double diagonal_of_target =
      sensitivity::deviation(target, to).max_percent > 0
          ? sensitivity::deviation(target, to).max / sensitivity::deviation(target, to).max_percent
          : 0;
  other.points = std::move(from);
  const double moved = sensitivity::deviation(other, to).max;
  return diagonal_of_target > 0 ? moved / diagonal_of_target : 0;
}

}  // namespace

core::Expected<Simulation> simulate(const io::Design& design, const SimulateOptions& options) {
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
  simulation.moved_percent = moved_percent(target, poses, found.state);
  record(structure, found.state, tensions, target, units, simulation.design);
  if (!simulation.usable())
    simulation.design.status = found.reason == equilibrium::Reason::stopped
                                   ? io::DesignStatus::interrupted
                                   : io::DesignStatus::tolerance_not_reached;
  return simulation;
}

}  // namespace tencer::pipeline
