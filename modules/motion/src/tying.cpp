#include <algorithm>
#include <cmath>
#include <limits>
#include <tencer/certify/closest.hpp>
#include <tencer/certify/strands.hpp>
#include <tencer/core/error.hpp>
#include <tencer/equilibrium/branch.hpp>
#include <tencer/equilibrium/constrained.hpp>
#include <tencer/equilibrium/modal.hpp>
#include <tencer/motion/actuate.hpp>
#include <tencer/motion/tying.hpp>
#include <utility>

#include "fit.hpp"

namespace tencer::motion {
namespace {

// A structure with some of its cables, at rest.
struct Partial {
  model::Structure structure{};  // rest lengths: as at the pose
  model::State state{};
  Eigen::VectorXd tensions{};
  std::vector<int> cables{};  // the finished structure's, ascending
};

Eigen::VectorXd rest_lengths(const model::Structure& structure) {
  Eigen::VectorXd lengths(static_cast<Eigen::Index>(structure.cables.size()));
  for (std::size_t c = 0; c < structure.cables.size(); ++c)
    lengths[static_cast<Eigen::Index>(c)] = structure.cables[c].rest_length;
  return lengths;
}

Partial without(const Partial& from, std::size_t k, const model::State& state,
                const Eigen::VectorXd& tensions) {
  Partial rest{.structure = from.structure, .state = state, .cables = from.cables};
  const auto at = static_cast<std::ptrdiff_t>(k);
  rest.structure.cables.erase(rest.structure.cables.begin() + at);
  rest.cables.erase(rest.cables.begin() + at);
  rest.tensions.resize(tensions.size() - 1);
  rest.tensions << tensions.head(at), tensions.tail(tensions.size() - at - 1);
  return rest;
}

// How far letting go of each cable moves the structure, to first order; 0 for slack ones, infinite
// where nothing is known.
Eigen::VectorXd first_order_motions(const Partial& partial) {
  const auto count = static_cast<Eigen::Index>(partial.cables.size());
  Eigen::VectorXd motions = Eigen::VectorXd::Zero(count);
  const std::vector<int> taut = equilibrium::taut_cables(partial.tensions);
  const equilibrium::System system =
      equilibrium::taut_system(partial.structure, partial.state, partial.tensions, taut);
  equilibrium::ConstrainedHessian hessian(system, partial.state,
                                          equilibrium::length_gradients(system, partial.state),
                                          equilibrium::lumped_mass(system));
  const bool known = hessian.factorise();
  const auto size = static_cast<Eigen::Index>(taut.size());
  equilibrium::ConstrainedResponse response;
  if (known)
    response = hessian.respond(Eigen::MatrixXd::Zero(system.size(), size),
                               Eigen::MatrixXd::Identity(size, size));
  for (Eigen::Index i = 0; i < size; ++i) {
    const int c = taut[static_cast<std::size_t>(i)];
    // Longer by so much it goes slack.
    const double longer = known ? -partial.tensions[c] / response.tension(i, i) : 0;
    motions[c] = longer > 0 ? longer * response.motion.col(i).cwiseAbs().maxCoeff()
                            : std::numeric_limits<double>::infinity();
  }
  return motions;
}

std::optional<double> strands_apart(const Partial& partial) {
  const auto closest = certify::closest(partial.structure, partial.state);
  return closest.rods ? std::optional(closest.rods->distance) : std::nullopt;
}

class TakingApart {
 public:
  TakingApart(const model::Structure& structure, const model::State& state,
              const Eigen::VectorXd& tensions, const std::stop_token& stop)
      : now_{structure, state, tensions, {}}, stop_(stop) {
    const Eigen::VectorXd lengths = equilibrium::lengths_at(structure, state, tensions);
    for (std::size_t c = 0; c < structure.cables.size(); ++c) {
      now_.structure.cables[c].rest_length = lengths[static_cast<Eigen::Index>(c)];
      now_.cables.push_back(static_cast<int>(c));
    }
    least_apart_ = std::min(0.0, strands_apart(now_).value_or(0.0));
    size_ = model::total_length(structure);
  }

  TyingPlan run() {
    while (release_one()) {
    }
    result_.finished = !stop_.stop_requested();
    std::ranges::reverse(result_.steps);
    return std::move(result_);
  }

 private:
  // Lets go of one more cable. False: none can be.
  bool release_one() {
    const Eigen::VectorXd motions = first_order_motions(now_);
    std::vector<Eigen::Index> order(now_.cables.size());
    for (std::size_t k = 0; k < order.size(); ++k) order[k] = static_cast<Eigen::Index>(k);
    std::ranges::stable_sort(order, {}, [&](Eigen::Index k) { return motions[k]; });
    result_.held.clear();
    for (const Eigen::Index k : order) {
      if (stop_.stop_requested()) break;
      const auto obstacle = release(static_cast<std::size_t>(k));
      if (!obstacle) return true;
      result_.held.push_back({now_.cables[static_cast<std::size_t>(k)], *obstacle});
    }
    if (stop_.stop_requested()) {
      result_.held.clear();
      for (const int cable : now_.cables) result_.held.push_back({cable, Obstacle::falls});
    }
    return false;
  }

  std::optional<Obstacle> release(std::size_t k) {
    const auto c = static_cast<Eigen::Index>(k);
    Partial loose = now_;
    for (int times = 0; loose.tensions[c] > 0; ++times) {
      constexpr int most = 40;
      if (times == most) return Obstacle::falls;
      if (const auto obstacle = lengthen(loose, c)) return obstacle;
    }
    Partial rest = without(loose, k, loose.state, loose.tensions);
    const std::vector<int> parts = model::components(rest.structure);
    result_.steps.push_back({.cable = now_.cables[k],
                             .moved = distance(now_.structure, now_.state, rest.state),
                             .tension = now_.tensions[c],
                             .parts = *std::ranges::max_element(parts) + 1,
                             .before = rest.state});
    now_ = std::move(rest);
    return std::nullopt;
  }

  // Lets out some of the cable.
  std::optional<Obstacle> lengthen(Partial& partial, Eigen::Index c) const {
    constexpr double calm = 0.01;  // of the rods' length: what is no fall
    Eigen::VectorXd longer = rest_lengths(partial.structure);
    longer[c] *= 1.3;
    const Actuation way = actuate(partial.structure, partial.state, partial.tensions,
                                  {{.lengths = longer, .frames = 3}}, stop_);
    if (!way.finished) return Obstacle::falls;
    for (const Jump& jump : way.jumps)
      if (!jump.smooth && jump.moved > calm * size_) return Obstacle::falls;
    for (const Frame& frame : way.frames)
      if (frame.closest.rods && frame.closest.rods->distance < least_apart_)
        return Obstacle::touches;
    const Frame& last = way.frames.back();
    if (certify::strands_meet(partial.structure, model::positions_of(partial.state),
                              fitted(partial.structure, last.state, partial.state)))
      return Obstacle::touches;
    partial.state = last.state;
    partial.tensions = last.tensions;
    for (std::size_t i = 0; i < partial.structure.cables.size(); ++i)
      partial.structure.cables[i].rest_length = longer[static_cast<Eigen::Index>(i)];
    return std::nullopt;
  }

  Partial now_;
  std::stop_token stop_;
  double least_apart_ = 0.0;  // of strands, or they overlap more than in the finished structure
  double size_ = 0.0;
  TyingPlan result_{};
};

}  // namespace

TyingPlan tying_plan(const model::Structure& structure, const model::State& state,
                     const Eigen::VectorXd& tensions, const std::stop_token& stop) {
  const auto count = static_cast<Eigen::Index>(structure.cables.size());
  core::require(tensions.size() == count && (count == 0 || tensions.minCoeff() >= 0),
                "tying_plan: needs one tension >= 0 per cable");
  return TakingApart(structure, state, tensions, stop).run();
}

}  // namespace tencer::motion
