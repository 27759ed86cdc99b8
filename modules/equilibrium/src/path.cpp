#include <algorithm>
#include <cmath>
#include <limits>
#include <tencer/core/error.hpp>
#include <tencer/equilibrium/balancing.hpp>
#include <tencer/equilibrium/path.hpp>
#include <utility>

#include "forces.hpp"
#include "pulling_cables.hpp"
#include "taut_linearisation.hpp"

namespace tencer::equilibrium {
namespace {

model::Structure with_lengths(model::Structure structure, const Eigen::VectorXd& lengths) {
  for (std::size_t c = 0; c < structure.cables.size(); ++c)
    structure.cables[c].rest_length = lengths[static_cast<Eigen::Index>(c)];
  return structure;
}

// A structure at whose state the cables' lengths are those they have there; as springs they pull as
// they are told and neither push nor go slack.
model::Structure at_own_lengths(model::Structure structure, const model::State& state) {
  for (auto& cable : structure.cables) cable.tension_only = false;
  const Eigen::VectorXd lengths = model::cable_lengths(structure, state);
  for (Eigen::Index c = 0; c < lengths.size(); ++c)
    core::require(lengths[c] > 0, "PathStart: the ends of a cable meet");
  return with_lengths(std::move(structure), lengths);
}

}  // namespace

void PathOptions::validate() const {
  core::require(max_step > 0, "PathOptions::max_step must be positive");
  core::require(max_departure > 0, "PathOptions::max_departure must be positive");
  core::require(min_step > 0 && min_step <= 1, "PathOptions::min_step must be in (0, 1]");
}

struct PathStart::Implementation {
  model::Structure structure;
  model::State state;
  Eigen::VectorXd tensions;
  Eigen::VectorXd lengths;
  Eigen::VectorXd imbalance{};  // the gradient there
  TautLinearisation linearisation{};
  bool stable = false;
};

PathStart::PathStart(model::Structure structure, model::State state,
                     const std::optional<Eigen::VectorXd>& tensions) {
  const auto count = static_cast<Eigen::Index>(structure.cables.size());
  core::require(
      !tensions || (tensions->size() == count && (count == 0 || tensions->minCoeff() >= 0)),
      "PathStart: needs one tension >= 0 per cable");
  auto start = std::make_unique<Implementation>();
  start->structure = at_own_lengths(std::move(structure), state);
  start->state = std::move(state);
  System system(start->structure);
  start->tensions = tensions ? *tensions : balancing_tensions(start->structure, start->state);
  start->lengths = cable_lengths(system, start->state);
  start->imbalance = gradient_with(system, start->state, start->tensions);
  InternalForces forces = system.internal_forces(start->state);
  forces.tension = start->tensions;
  start->stable =
      start->imbalance.allFinite() && start->linearisation.linearise(system, start->state, forces);
  implementation_ = std::move(start);
}

PathStart::~PathStart() = default;
PathStart::PathStart(PathStart&&) noexcept = default;
PathStart& PathStart::operator=(PathStart&&) noexcept = default;
const Eigen::VectorXd& PathStart::lengths() const { return implementation_->lengths; }

namespace {

struct Pose {
  model::State state{};
  InternalForces forces{};  // axial ones as the last step predicts them; the cables' tensions
};

enum class Accuracy { of_path, of_rest };

// The equilibria for lengths and lacking forces between those of the start and those wanted.
class Path {
 public:
  Path(const model::Structure& structure, const Eigen::VectorXd& start_lengths,
       const Eigen::VectorXd& lengths, const Eigen::VectorXd& imbalance, const PathOptions& options,
       Equilibrium& counts)
      : system_(structure),
        start_lengths_(start_lengths),
        change_(lengths - start_lengths),
        imbalance_(imbalance),
        options_(options),
        counts_(counts) {
    for (const auto& rod : structure.rods) longest_ = std::max(longest_, rod.length());
  }

  System& system() { return system_; }

  // The Newton step from `pose` to the equilibrium after this part of the way.
  TautStep step(const Pose& pose, double part, const TautLinearisation& at) {
    ++counts_.iterations;
    return at.step(gradient(pose, part, at), pose.forces.tension,
                   start_lengths_ + part * change_ - cable_lengths(system_, pose.state));
  }

  Pose moved(const Pose& from, const TautStep& step) {
    ++counts_.evaluations;
    Pose pose{.state = system_.displaced(from.state, step.motion),
              .forces = predicted_forces(system_, from.state, step.motion)};
    pose.forces.tension = step.tensions;
    return pose;
  }

  // Newton's method for the equilibrium after this part of the way, no further than `reach` from
  // `pose`; `at` is linearised next to it afterwards. False: there is none, or it is not stable.
  bool correct(Pose& pose, double part, double reach, Accuracy accuracy, TautLinearisation& at) {
    constexpr int most = 8;
    constexpr double next_to = 0.01;
    for (int k = 0; k < most; ++k) {
      ++counts_.factorisations;
      if (!at.linearise(system_, pose.state, pose.forces)) return false;
      const double left = reach;
      if (approach(pose, part, reach, accuracy, at))
        return left - reach < next_to || at.linearise(system_, pose.state, pose.forces);
      if (!(reach >= 0)) return false;
    }
    return false;
  }

  // The same while each step with the linearisation at hand gains a digit; `reach` is less by what
  // it moved, and negative where it went too far.
  bool approach(Pose& pose, double part, double& reach, Accuracy accuracy,
                const TautLinearisation& at) {
    double last = std::numeric_limits<double>::infinity();
    for (bool gaining = true; gaining;) {
      const TautStep next = step(pose, part, at);
      const double size =
          next.solved ? this->size(pose, next) : std::numeric_limits<double>::infinity();
      reach -= size;
      if (!(reach >= 0)) return false;
      pose = moved(pose, next);
      if (arrived(pose, part, size, last, accuracy, at)) return true;
      gaining = size < last / 10;
      last = size;
    }
    return false;
  }

  // Turn of an edge, or motion over the longest rod's length.
  double size(const Pose& pose, const TautStep& step) const {
    return std::max(largest_rotation(system_, pose.state, step.motion),
                    largest_motion(system_, step.motion) / longest_);
  }

 private:
  // What is left of the lacking forces does no work in rigid motions, as the rods' own do not.
  Eigen::VectorXd gradient(const Pose& pose, double part, const TautLinearisation& at) const {
    Eigen::VectorXd gradient = gradient_with(system_, pose.state, pose.forces.tension);
    if (part == 1) return gradient;
    Eigen::VectorXd lacking = (1 - part) * imbalance_;
    remove_rigid(at.rigid(), lacking);
    return gradient - lacking;
  }

  bool arrived(const Pose& pose, double part, double size, double last, Accuracy accuracy,
               const TautLinearisation& at) const {
    constexpr double near = 1e-6;
    if (size > near) return false;
    if (accuracy == Accuracy::of_path) return true;
    const Eigen::VectorXd left = gradient(pose, part, at);
    const double residual = relative_residual(system_, left, system_.rod_gradient(pose.state));
    const bool balanced =
        residual <= options_.solve.tolerance || is_rounding(system_, pose.state, left);
    return balanced && (size <= 1e-9 || size > last / 2);
  }

  System system_;
  const Eigen::VectorXd& start_lengths_;
  Eigen::VectorXd change_;
  const Eigen::VectorXd& imbalance_;
  const PathOptions& options_;
  Equilibrium& counts_;
  double longest_ = 0;
};

// What is found at the end of the way, in full balance.
InextensibleEquilibrium at_rest(System& system, const Pose& pose, const Eigen::VectorXd& lengths,
                                double tolerance) {
  const Eigen::VectorXd gradient = gradient_with(system, pose.state, pose.forces.tension);
  InextensibleEquilibrium rest{.tensions = pose.forces.tension};
  rest.equilibrium.state = pose.state;
  rest.equilibrium.residual = relative_residual(system, gradient, system.rod_gradient(pose.state));
  rest.equilibrium.reason =
      rest.equilibrium.residual <= tolerance ? Reason::converged : Reason::rounding;
  const Eigen::VectorXd now = cable_lengths(system, pose.state);
  for (Eigen::Index c = 0; c < now.size(); ++c) {
    const double excess = now[c] / lengths[c] - 1;
    rest.stretch = std::max(rest.stretch, rest.tensions[c] > 0 ? std::abs(excess) : excess);
  }
  std::vector<springs::Cable> cables = system.structure().cables;
  for (auto& cable : cables) cable.stiffness = 0;  // inextensible cables hold no energy
  system.set_cables(std::move(cables));
  rest.equilibrium.energy = system.energy(pose.state);
  return rest;
}

}  // namespace

PathEquilibrium settle_along(const PathStart& given, const Eigen::VectorXd& lengths,
                             const PathOptions& options) {
  options.validate();
  const PathStart::Implementation& start = *given.implementation_;
  core::require(
      lengths.size() == start.lengths.size() && (lengths.size() == 0 || lengths.minCoeff() > 0),
      "settle_along: needs one length > 0 per cable");
  PathEquilibrium result{.held = start.stable};
  Equilibrium counts;
  Path path(start.structure, start.lengths, lengths, start.imbalance, options, counts);
  Pose now{.state = start.state, .forces = path.system().internal_forces(start.state)};
  now.forces.tension = start.tensions;
  TautLinearisation trial, last;
  const TautLinearisation* at = &start.linearisation;  // at `now`

  double part = 0;
  double step = 1;
  while (result.held && part < 1 && !options.solve.stop.stop_requested()) {
    if (step < options.min_step) {
      result.fold_at = part;
      break;
    }
    const double next = step < 1 - part ? part + step : 1.0;
    const TautStep predicted = path.step(now, next, *at);
    // Cables that go taut and slack in turn leave a rough step; what is not finite leaves none.
    const double rough =
        predicted.motion.size() > 0 ? options.max_step : std::numeric_limits<double>::infinity();
    const double size = predicted.solved ? path.size(now, predicted) : rough;
    if (!(size <= options.max_step)) {
      step = (next - part) * std::clamp(options.max_step / size / 2, 0.1, 0.5);
      continue;
    }
    Pose pose = path.moved(now, predicted);
    if (path.correct(pose, next, options.max_departure * size + 1e-5, Accuracy::of_path, trial)) {
      ++result.steps;
      now = std::move(pose);
      std::swap(trial, last);
      at = &last;
      part = next;
      step *= 2;
    } else {
      ++result.rejected;
      step = (next - part) / 4;
    }
  }
  double reach = 1e-3;
  if (part == 1 && (path.approach(now, 1, reach, Accuracy::of_rest, *at) ||
                    path.correct(now, 1, reach, Accuracy::of_rest, trial))) {
    result.rest = at_rest(path.system(), now, lengths, options.solve.tolerance);
  } else if (options.beyond_fold || part == 1) {
    result.rest = relax_inextensible(with_lengths(start.structure, lengths), std::move(now.state),
                                     now.forces.tension, options.solve);
  }
  result.rest.equilibrium.iterations += counts.iterations;
  result.rest.equilibrium.factorisations += counts.factorisations;
  result.rest.equilibrium.evaluations += counts.evaluations;
  return result;
}

PathEquilibrium settle_along(const model::Structure& structure, model::State start,
                             const std::optional<Eigen::VectorXd>& tensions,
                             const PathOptions& options) {
  Eigen::VectorXd lengths(static_cast<Eigen::Index>(structure.cables.size()));
  for (Eigen::Index c = 0; c < lengths.size(); ++c)
    lengths[c] = structure.cables[static_cast<std::size_t>(c)].rest_length;
  PathEquilibrium result =
      settle_along(PathStart(structure, std::move(start), tensions), lengths, options);
  ++result.rest.equilibrium.factorisations;  // at the start
  return result;
}

}  // namespace tencer::equilibrium
