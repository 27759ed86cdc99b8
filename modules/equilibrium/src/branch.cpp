#include <algorithm>
#include <cmath>
#include <functional>
#include <optional>
#include <tencer/core/error.hpp>
#include <tencer/equilibrium/branch.hpp>
#include <utility>

#include "branch_steps.hpp"
#include "pulling_cables.hpp"

namespace tencer::equilibrium {
namespace {

class Tracer {
 public:
  Tracer(const model::Structure& structure, const Eigen::VectorXd& start_lengths,
         const Eigen::VectorXd& lengths, const BranchOptions& options)
      : steps_(structure, start_lengths, lengths),
        rods_(without_cables(structure)),
        options_(options) {}

  Branch follow(const model::State& state, const Eigen::VectorXd& tensions) {
    std::optional<Spot> spot = steps_.start(state, tensions);
    if (!spot) return {};
    record(*spot, Passing::none, true);
    double length = options_.max_step / steps_.pace(*spot);
    while (!ended(*spot))
      if (!advance(*spot, length)) {
        branch_.end = BranchEnd::lost;
        break;
      }
    return std::move(branch_);
  }

 private:
  struct Reached {
    Spot spot{};
    bool frame = false;
  };

  static model::Structure without_cables(model::Structure structure) {
    structure.cables.clear();
    return structure;
  }

  bool ended(const Spot& spot) {
    const auto end = [&](BranchEnd how) {
      branch_.end = how;
      return true;
    };
    if (options_.stop.stop_requested()) return end(BranchEnd::stopped);
    if (spot.tangent.part > 0 && spot.pose.part >= 1) return end(BranchEnd::arrived);
    if (spot.tangent.part < 0 && spot.pose.part <= 0) return end(BranchEnd::back);
    if (options_.stable_only && (spot.negative > 0 || spot.tangent.part < 0))
      return end(BranchEnd::unstable);
    return static_cast<int>(branch_.points.size()) >= options_.max_points &&
           end(BranchEnd::many_points);
  }

  void record(const Spot& spot, Passing passing, bool frame) {
    branch_.points.push_back({.part = spot.pose.part,
                              .state = spot.pose.state,
                              .tensions = spot.pose.forces.tension.cwiseMax(0),
                              .energy = rods_.energy(spot.pose.state),
                              .negative = spot.negative,
                              .forward = spot.tangent.part > 0,
                              .passing = passing,
                              .frame = frame});
  }

  // The next part of the way that a frame ends at.
  double next_frame(const Spot& from) const {
    constexpr double here = 1e-9;
    const double at = from.pose.part * options_.frames;
    return from.tangent.part > 0 ? (std::floor(at + here) + 1) / options_.frames
                                 : (std::ceil(at - here) - 1) / options_.frames;
  }

  // One step of at most `length`, which grows and shrinks as steps succeed and fail.
  std::optional<Reached> try_steps(const Spot& from, double& length) {
    const double pace = steps_.pace(from);
    length = std::min(length, options_.max_step / pace);
    while (length * pace >= options_.min_step) {
      const double to_frame = (next_frame(from) - from.pose.part) / from.tangent.part;
      const bool frame = std::isfinite(to_frame) && to_frame <= length;
      if (frame) {
        if (auto spot = steps_.reached(from, to_frame, next_frame(from)))
          return Reached{std::move(*spot), true};
        length = to_frame / 2;
      } else if (auto spot = steps_.reached(from, length)) {
        length *= 1.5;
        return Reached{std::move(*spot), false};
      } else {
        length /= 2;
      }
    }
    return std::nullopt;
  }

  // On to the next point, with what is passed on the way there. False: lost.
  bool advance(Spot& from, double& length) {
    std::optional<Reached> next = try_steps(from, length);
    if (!next) return false;
    Eigen::Index cable = -1;  // goes slack or taut first
    for (Eigen::Index c = steps_.beyond(next->spot.pose); c >= 0 && c != cable;
         c = steps_.beyond(next->spot.pose)) {
      constexpr double none = 1e-9;
      const auto margin = [&](const Spot& spot) { return steps_.margin(spot.pose, c); };
      // At its limit already; one that would go slack and taut in turn cannot be followed.
      if (margin(from) < none) return c != toggled_ && pass_event(from, c);
      next = Reached{between(from, next->spot, margin), false};
      cable = c;
    }
    Spot& to = next->spot;
    record_passed(from, to);
    if (cable < 0) {
      toggled_ = -1;
      record(to, Passing::none, next->frame);
    } else if (!pass_event(to, cable)) {
      return false;
    }
    from = std::move(to);
    return true;
  }

  // What is between two spots with the same cables taut.
  void record_passed(const Spot& from, const Spot& to) {
    const bool turns = from.tangent.part * to.tangent.part < 0;
    if (!turns && from.negative == to.negative) return;
    Spot passed = turns ? between(from, to, [](const Spot& spot) { return spot.tangent.part; })
                        : where_stability_changes(from, to);
    passed.negative = to.negative;
    passed.tangent.part = to.tangent.part;
    record(passed, turns ? Passing::turning : Passing::branching, false);
  }

  // A cable goes slack or taut at `to`.
  bool pass_event(Spot& to, Eigen::Index cable) {
    const bool was_forward = to.tangent.part > 0;
    const bool was_stable = to.negative == 0;
    if (!steps_.toggle(to, cable)) return false;
    toggled_ = cable;
    const bool turns = was_forward != (to.tangent.part > 0);
    const bool branches = was_stable != (to.negative == 0);
    const Passing event =
        to.pose.taut[static_cast<std::size_t>(cable)] ? Passing::taut : Passing::slack;
    record(to, turns ? Passing::turning : branches ? Passing::branching : event, false);
    return true;
  }

  // The spot between `from` and `to` where `value`, positive or not at its ends, is zero: false
  // position, as Illinois has it.
  Spot between(const Spot& from, const Spot& to, const std::function<double(const Spot&)>& value) {
    constexpr int most = 40;
    double low = 0, high = to.gone;
    double at_low = value(from), at_high = value(to);
    Spot found = to;
    int side = 0;
    for (int k = 0; k < most && high - low > 1e-10 * to.gone && std::abs(at_high) > 1e-12; ++k) {
      const double share = std::clamp(at_low / (at_low - at_high), 1e-3, 1 - 1e-3);
      const double middle = low + share * (high - low);
      std::optional<Spot> next = steps_.reached(from, middle);
      if (!next) break;
      const double at_middle = value(*next);
      if ((at_middle > 0) == (at_low > 0)) {
        low = middle;
        at_low = at_middle;
        if (side == 1) at_high /= 2;
        side = 1;
      } else {
        high = middle;
        at_high = at_middle;
        if (side == -1) at_low /= 2;
        side = -1;
        found = std::move(*next);
      }
    }
    return found;
  }

  // Just beyond where the number of unstable directions changes: next to it the structure is soft,
  // and long steps may fail.
  Spot where_stability_changes(const Spot& from, const Spot& to) {
    Spot before = from, beyond = to;
    for (double step = to.gone / 2; step > 1e-6 * to.gone; step /= 2) {
      std::optional<Spot> next = steps_.reached(before, step);
      if (!next) continue;
      (next->negative == from.negative ? before : beyond) = std::move(*next);
    }
    return beyond;
  }

  BranchSteps steps_;
  System rods_;
  BranchOptions options_;
  Eigen::Index toggled_ = -1;  // the cable that went slack or taut at the last point
  Branch branch_{};
};

}  // namespace

void BranchOptions::validate() const {
  core::require(max_step > 0, "BranchOptions::max_step must be positive");
  core::require(min_step > 0, "BranchOptions::min_step must be positive");
  core::require(frames >= 1, "BranchOptions::frames must be at least 1");
  core::require(max_points >= 1, "BranchOptions::max_points must be at least 1");
}

Eigen::VectorXd lengths_at(const model::Structure& structure, const model::State& state,
                           const Eigen::VectorXd& tensions) {
  Eigen::VectorXd lengths = model::cable_lengths(structure, state);
  for (Eigen::Index c = 0; c < lengths.size(); ++c)
    if (!(tensions[c] > 0))
      lengths[c] = std::max(lengths[c], structure.cables[static_cast<std::size_t>(c)].rest_length);
  return lengths;
}

Branch follow_branch(const model::Structure& structure, const model::State& state,
                     const Eigen::VectorXd& tensions, const Eigen::VectorXd& lengths,
                     const BranchOptions& options) {
  options.validate();
  const auto count = static_cast<Eigen::Index>(structure.cables.size());
  core::require(tensions.size() == count && (count == 0 || tensions.minCoeff() >= 0),
                "follow_branch: needs one tension >= 0 per cable");
  core::require(lengths.size() == count && (count == 0 || lengths.minCoeff() > 0),
                "follow_branch: needs one length > 0 per cable");
  model::Structure held = structure;
  for (auto& cable : held.cables) cable.tension_only = false;
  return Tracer(held, lengths_at(structure, state, tensions), lengths, options)
      .follow(state, tensions);
}

}  // namespace tencer::equilibrium
