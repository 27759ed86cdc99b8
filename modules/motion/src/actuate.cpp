#include <algorithm>
#include <cmath>
#include <tencer/certify/strands.hpp>
#include <tencer/core/error.hpp>
#include <tencer/equilibrium/branch.hpp>
#include <tencer/equilibrium/inextensible.hpp>
#include <tencer/motion/actuate.hpp>
#include <utility>

#include "fit.hpp"

namespace tencer::motion {
namespace {

using equilibrium::Branch;
using equilibrium::BranchEnd;
using equilibrium::BranchPoint;
using equilibrium::Passing;

struct Reached {
  model::State state{};
  Eigen::VectorXd tensions{};
  double part = 0.0;  // of the leg
};

class Actuator {
 public:
  Actuator(const model::Structure& structure, const std::stop_token& stop)
      : structure_(structure), rods_(without_cables(structure)), stop_(stop) {}

  Actuation run(const model::State& state, const Eigen::VectorXd& tensions,
                const std::vector<Leg>& legs) {
    now_ = {state, tensions, 0};
    lengths_ = equilibrium::lengths_at(structure_, state, tensions);
    add_frame(0, now_);
    for (std::size_t k = 0; k < legs.size(); ++k) {
      leg_ = static_cast<int>(k);
      from_ = lengths_;
      to_ = legs[k].lengths;
      now_.part = 0;
      if (!follow(legs[k].frames)) return std::move(result_);
    }
    result_.finished = true;
    return std::move(result_);
  }

 private:
  static model::Structure without_cables(model::Structure structure) {
    structure.cables.clear();
    return structure;
  }

  Eigen::VectorXd lengths_after(double part) const { return from_ + part * (to_ - from_); }

  void set_lengths(const Eigen::VectorXd& lengths) {
    lengths_ = lengths;
    for (std::size_t c = 0; c < structure_.cables.size(); ++c)
      structure_.cables[c].rest_length = lengths[static_cast<Eigen::Index>(c)];
  }

  void add_frame(double part, const Reached& rest) {
    result_.frames.push_back({.leg = leg_,
                              .part = part,
                              .state = rest.state,
                              .lengths = lengths_,
                              .tensions = rest.tensions,
                              .energy = rods_.energy(rest.state),
                              .closest = certify::closest(structure_, rest.state)});
  }

  // The leg to its end, jump after jump. False: no rest was found, or it was stopped.
  bool follow(int frames) {
    constexpr int most_jumps = 100;
    for (int jumps = 0; now_.part < 1; ++jumps) {
      if (stop_.stop_requested() || jumps > most_jumps) return false;
      const double left = 1 - now_.part;
      const int frames_left = std::max(1, static_cast<int>(std::ceil(frames * left - 1e-9)));
      const Branch branch =
          equilibrium::follow_branch(structure_, now_.state, now_.tensions, to_,
                                     {.frames = frames_left, .stable_only = true, .stop = stop_});
      const double start = now_.part;
      const BranchPoint* last = nullptr;  // of the stable ones
      for (const BranchPoint& point : branch.points) {
        const bool leaves =
            point.passing == Passing::turning || point.passing == Passing::branching;
        if (point.negative > 0 && !leaves) break;
        last = &point;
        if (leaves) break;
        if (point.frame && point.part > 0) advance_to(point, start);
      }
      if (branch.end == BranchEnd::arrived) return true;
      if (branch.end == BranchEnd::stopped) return false;
      if (last && last->part > 0) advance_to(*last, start);
      if (!jump(last ? cause_of(*last) : Cause::lost)) return false;
    }
    return true;
  }

  static Cause cause_of(const BranchPoint& point) {
    return point.passing == Passing::turning     ? Cause::turning
           : point.passing == Passing::branching ? Cause::branching
                                                 : Cause::lost;
  }

  void advance_to(const BranchPoint& point, double start) {
    const double part = point.part >= 1 ? 1.0 : start + (1 - start) * point.part;
    set_lengths(lengths_after(part));
    now_ = {point.state, point.tensions, part};
    add_frame(part, now_);
  }

  std::optional<Reached> rest_after(double further) {
    const double part = std::min(1.0, now_.part + further);
    model::Structure pulled = structure_;
    const Eigen::VectorXd lengths = lengths_after(part);
    for (std::size_t c = 0; c < pulled.cables.size(); ++c)
      pulled.cables[c].rest_length = lengths[static_cast<Eigen::Index>(c)];
    auto found = equilibrium::relax_inextensible(pulled, now_.state, now_.tensions,
                                                 {.patience = 0, .stop = stop_});
    if (!found.equilibrium.usable()) return std::nullopt;
    return Reached{std::move(found.equilibrium.state), std::move(found.tensions), part};
  }

  // To where the structure comes to rest from the last frame.
  bool jump(Cause cause) {
    constexpr double far = 1e-3;
    constexpr double near = 1e-5;
    std::optional<Reached> further = rest_after(far);
    std::optional<Reached> nearer = rest_after(near);
    if (!further && !nearer) return false;
    const auto moved = [&](const Reached& rest) {
      return distance(structure_, result_.frames.back().state, rest.state);
    };
    // Poses that begin here are as far away as the root of how far on, or nearer.
    const bool smooth = further && nearer && moved(*nearer) < moved(*further) / 3;
    const Reached& rest = smooth || !nearer ? *further : *nearer;
    const Frame before = result_.frames.back();
    Jump made{.before = static_cast<int>(result_.frames.size()) - 1,
              .after = static_cast<int>(result_.frames.size()),
              .cause = cause,
              .smooth = smooth,
              .moved = moved(rest)};
    set_lengths(lengths_after(rest.part));
    add_frame(rest.part, rest);
    const Frame& after = result_.frames.back();
    made.released = before.energy - after.energy;
    made.strands_met = certify::strands_meet(structure_, model::positions_of(before.state),
                                             fitted(structure_, after.state, before.state));
    result_.jumps.push_back(made);
    now_ = rest;
    return true;
  }

  model::Structure structure_;  // its rest lengths are those at now_
  equilibrium::System rods_;
  std::stop_token stop_;
  Eigen::VectorXd lengths_{}, from_{}, to_{};
  Reached now_{};
  int leg_ = 0;
  Actuation result_{};
};

}  // namespace

Actuation actuate(const model::Structure& structure, const model::State& state,
                  const Eigen::VectorXd& tensions, const std::vector<Leg>& legs,
                  const std::stop_token& stop) {
  const auto count = static_cast<Eigen::Index>(structure.cables.size());
  core::require(tensions.size() == count && (count == 0 || tensions.minCoeff() >= 0),
                "actuate: needs one tension >= 0 per cable");
  for (const Leg& leg : legs) {
    core::require(leg.lengths.size() == count && (count == 0 || leg.lengths.minCoeff() > 0),
                  "actuate: every leg needs one length > 0 per cable");
    core::require(leg.frames >= 1, "actuate: every leg needs at least one frame");
  }
  return Actuator(structure, stop).run(state, tensions, legs);
}

}  // namespace tencer::motion
