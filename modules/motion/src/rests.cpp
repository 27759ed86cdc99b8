#include <algorithm>
#include <cmath>
#include <map>
#include <tencer/certify/closest.hpp>
#include <tencer/certify/strands.hpp>
#include <tencer/certify/tolerance.hpp>
#include <tencer/core/error.hpp>
#include <tencer/equilibrium/constrained.hpp>
#include <tencer/equilibrium/flow.hpp>
#include <tencer/equilibrium/inextensible.hpp>
#include <tencer/equilibrium/stationary.hpp>
#include <tencer/model/target.hpp>
#include <tencer/motion/rests.hpp>
#include <utility>

#include "fit.hpp"

namespace tencer::motion {
namespace {

using equilibrium::Descent;
using equilibrium::Flow;
using equilibrium::FlowPose;

// Where fingers touch and which way they go, both per rod, 3 x n.
struct Grip {
  Positions along{};    // 1 where a finger touches
  Positions weights{};  // the same for all coordinates of a vertex
};

// A hand's way, pose by pose.
struct Push {
  std::vector<FlowPose> poses{};  // the first is the rest
  std::vector<double> parts{};    // of its way that the fingers have gone
  Eigen::VectorXd whole{};        // the fingers' way, per free unknown
  Eigen::VectorXd grip{};         // 1 where they touch
  Eigen::VectorXd springs{};      // see Flow::drawn
};

// Let go at two places of a push next to each other: from the first it comes back.
struct Parting {
  Descent back{};
  Descent away{};
};

class Finder {
 public:
  Finder(const model::Structure& structure, const RestsOptions& options)
      : structure_(structure), options_(options) {}

  Rests run(const model::State& state, const Eigen::VectorXd& tensions) {
    const model::Target target = model::make_target(structure_, model::positions_of(state));
    size_ = model::diagonal(target);
    held_ = !target.align;
    if (!rest_at(state, tensions)) return std::move(result_);
    for (int i = 0; i < std::min(options_.most_rests, static_cast<int>(result_.rests.size())); ++i)
      push_from(i);
    std::ranges::stable_sort(result_.passes, {}, &Pass::energy);
    result_.finished = !options_.stop.stop_requested();
    return std::move(result_);
  }

 private:
  const Rest& rest(int i) const { return result_.rests[static_cast<std::size_t>(i)]; }

  bool at_rest(int i, const model::State& state, double near) const {
    return distance(structure_, rest(i).state, state) < near * size_;
  }

  // The number of the rest at a state, or next to it, which is noted when it is new. Not set: it is
  // not stable there.
  std::optional<int> rest_at(const model::State& state, const Eigen::VectorXd& tensions) {
    constexpr double same = 1e-3;
    auto found =
        equilibrium::relax_inextensible(structure_, state, tensions, {.stop = options_.stop});
    if (!found.equilibrium.usable()) return std::nullopt;
    const model::State& at = found.equilibrium.state;
    for (int i = 0; i < static_cast<int>(result_.rests.size()); ++i)
      if (at_rest(i, at, same)) return i;
    const auto certain = equilibrium::assess(structure_, at, found.tensions);
    if (!certain.stability.stable()) return std::nullopt;
    const Flow flow(structure_, found.tensions);
    result_.rests.push_back(
        {.state = at,
         .tensions = certain.tensions,
         .energy = flow.at(at).energy,
         .softest = certain.stability.smallest_eigenvalue,
         .away = result_.rests.empty() ? 0.0 : distance(structure_, rest(0).state, at)});
    return static_cast<int>(result_.rests.size()) - 1;
  }

  // Down from there, to a rest that is known if it comes near one.
  Descent let_go(Flow& flow, const FlowPose& from) const {
    constexpr double near = 2e-3;
    return flow.descend(from, {.arrived =
                                   [this](const FlowPose& pose) {
                                     for (int i = 0; i < static_cast<int>(result_.rests.size());
                                          ++i)
                                       if (at_rest(i, pose.state, near)) return true;
                                     return false;
                                   },
                               .stop = options_.stop});
  }

  std::optional<int> end_of(const Descent& descent) {
    const FlowPose& last = descent.poses.back();
    return rest_at(last.state, last.forces.tension.cwiseMax(0));
  }

  void push_from(int from) {
    for (int k = 0; k < options_.directions && !options_.stop.stop_requested(); ++k)
      push(from, drawn_grip(options_.seed + static_cast<std::uint64_t>(k)));
  }

  // A finger somewhere that moves in some direction; a second one moves the other way where nothing
  // else holds the structure.
  Grip drawn_grip(std::uint64_t seed) const {
    const Eigen::VectorXd draws = certify::unit_draws(5, 1, seed).col(0);
    Eigen::Vector3d along = draws.head<3>();
    if (structure_.planar) along[2] = 0;
    along.normalize();
    Grip grip;
    for (const auto& rod : rest(0).state) {
      grip.along.push_back(Eigen::Matrix3Xd::Zero(3, rod.x.cols()));
      grip.weights.push_back(Eigen::Matrix3Xd::Zero(3, rod.x.cols()));
    }
    press(grip, (draws[3] + 1) / 2, along);
    if (!held_) press(grip, (draws[4] + 1) / 2, -along);
    return grip;
  }

  // Adds a finger at this part of all rods' length.
  void press(Grip& grip, double part, const Eigen::Vector3d& along) const {
    constexpr double wide = 0.05;  // of the rod's length
    double s = part * model::total_length(structure_);
    std::size_t r = 0;
    while (r + 1 < structure_.rods.size() && s > structure_.rods[r].length())
      s -= structure_.rods[r++].length();
    const der::Rod& rod = structure_.rods[r];
    const auto arc = model::arc_lengths(structure_)[r];
    for (int v = 0; v < rod.vertices(); ++v) {
      double apart = std::abs(arc.knots()[v] - s);
      if (rod.closed) apart = std::min(apart, rod.length() - apart);
      const double weight = std::exp(-std::pow(apart / (wide * rod.length()), 2));
      grip.along[r].col(v) += weight * along;
      grip.weights[r].col(v) = grip.weights[r].col(v).cwiseMax(weight);
    }
  }

  // Fingers are stiff beside the structure's softest motion; the rest of it is held back only as
  // much as it is stiff itself.
  Push hand(Flow& flow, int from, const Grip& grip) const {
    constexpr double finger = 300;
    constexpr double longest = 1.0 / 32, shortest = 1.0 / 1024;  // steps, of the whole push
    const Eigen::VectorXd weights = unknowns_of(flow.system(), grip.weights);
    Push result{.whole = options_.reach * size_ * unknowns_of(flow.system(), grip.along),
                .grip = weights,
                .springs = rest(from).softest * (1 + (finger - 1) * weights.array()).matrix()};
    result.poses.push_back(flow.at(rest(from).state));
    result.parts.push_back(0);
    for (double step = longest; result.parts.back() < 1 && step >= shortest;) {
      const double part = std::min(1.0, result.parts.back() + step);
      auto next = drawn_to(flow, result, result.poses.size() - 1, part);
      if (!next) {
        step /= 2;
        continue;
      }
      result.poses.push_back(std::move(*next));
      result.parts.push_back(part);
      step = std::min(longest, 2 * step);
    }
    return result;
  }

  // On from pose number k to where the fingers have gone a part of their way.
  static std::optional<FlowPose> drawn_to(Flow& flow, const Push& push, std::size_t k,
                                          double part) {
    Positions gone = model::positions_of(push.poses[k].state);
    for (std::size_t r = 0; r < gone.size(); ++r) gone[r] -= push.poses[0].state[r].x;
    const Eigen::VectorXd ahead =
        part * push.whole - push.grip.cwiseProduct(unknowns_of(flow.system(), gone));
    return flow.drawn(push.poses[k], ahead, push.springs);
  }

  static Eigen::VectorXd unknowns_of(const equilibrium::System& system, const Positions& moved) {
    Eigen::VectorXd step = Eigen::VectorXd::Zero(system.size());
    for (int r = 0; r < static_cast<int>(moved.size()); ++r)
      for (int v = 0; v < moved[static_cast<std::size_t>(r)].cols(); ++v)
        for (int axis = 0; axis < 3; ++axis)
          if (const int at = system.position_index(r, v, axis); at >= 0)
            step[at] = moved[static_cast<std::size_t>(r)](axis, v);
    return step;
  }

  // Pushed in one direction and let go half way and at the end.
  void push(int from, const Grip& grip) {
    Flow flow(structure_, rest(from).tensions);
    const Push push = hand(flow, from, grip);
    const auto last = push.poses.size() - 1;
    std::size_t back = 0;
    for (const std::size_t at : {last / 2, last}) {
      if (at == 0 || options_.stop.stop_requested()) continue;
      ++result_.pushes;
      Descent descent = let_go(flow, push.poses[at]);
      const auto end = end_of(descent);
      if (!end) {
        ++result_.lost;
        continue;
      }
      ++result_.rests[static_cast<std::size_t>(*end)].found;
      if (*end == from) {
        back = at;
      } else {
        if (wants_pass(from, *end) && !find_pass(flow, from, push, back, at, std::move(descent)))
          ++result_.passes_missed;
        return;
      }
    }
  }

  // Whether a pass between two rests is still looked for.
  bool wants_pass(int a, int b) {
    constexpr int tries = 3;
    return tried_[std::minmax(a, b)]++ < tries;
  }

  bool comes_back(int from, const Descent& descent) {
    const auto end = end_of(descent);
    return end && *end == from;
  }

  // Lets go ever nearer to where the descents part.
  bool find_pass(Flow& flow, int from, const Push& push, std::size_t back, std::size_t away,
                 Descent leaving) {
    constexpr int halvings = 16;
    constexpr int enough = 6;
    Parting parting{.away = std::move(leaving)};
    const auto try_at = [&](const FlowPose& at) {
      Descent descent = let_go(flow, at);
      const bool returns = comes_back(from, descent);
      (returns ? parting.back : parting.away) = std::move(descent);
      return returns;
    };
    while (away - back > 1) {
      const std::size_t middle = (back + away) / 2;
      (try_at(push.poses[middle]) ? back : away) = middle;
    }
    double low = push.parts[back], high = push.parts[away];
    for (int k = 1; k <= halvings && !options_.stop.stop_requested(); ++k) {
      const double middle = (low + high) / 2;
      const auto at = drawn_to(flow, push, back, middle);
      if (!at) return false;
      (try_at(*at) ? low : high) = middle;
      if (k >= enough && k % 2 == 0 && pass_near(parting)) return true;
    }
    return false;
  }

  // Where the descents are slowest on their ways.
  bool pass_near(const Parting& parting) {
    constexpr std::size_t tries = 2;
    for (const Descent* descent : {&parting.back, &parting.away}) {
      const auto& poses = descent->poses;
      std::vector<const FlowPose*> slow;
      for (std::size_t k = 2; k + 1 < poses.size(); ++k)
        if (poses[k].speed <= poses[k - 1].speed && poses[k].speed < poses[k + 1].speed)
          slow.push_back(&poses[k]);
      std::ranges::stable_sort(slow, {}, &FlowPose::speed);
      for (std::size_t k = 0; k < std::min(tries, slow.size()); ++k)
        if (pass_at(*slow[k])) return true;
    }
    return false;
  }

  bool pass_at(const FlowPose& near) {
    constexpr double reach = 0.5;
    equilibrium::InternalForces forces = near.forces;
    forces.tension = forces.tension.cwiseMax(0);
    const auto saddle = equilibrium::stationary_near(structure_, near.state, forces, reach);
    if (!saddle || saddle->negative != 1) return false;
    for (Pass& pass : result_.passes)
      if (distance(structure_, pass.way[static_cast<std::size_t>(pass.top)].state, saddle->state) <
          1e-3 * size_) {
        ++pass.found;
        return true;
      }
    return descend_from(*saddle);
  }

  bool descend_from(const equilibrium::Stationary& saddle) {
    constexpr double off = 0.01;  // of the size
    const auto stability = equilibrium::stability_inextensible(
        structure_, saddle.state, saddle.tensions, equilibrium::taut_cables(saddle.tensions));
    if (!stability.computed || stability.negative != 1 || stability.floating_components > 0)
      return false;
    Flow flow(structure_, saddle.tensions);
    const FlowPose top = flow.at(saddle.state);
    Pass pass{.energy = top.energy};
    std::vector<WayPose>& way = pass.way;
    for (const double side : {-1.0, 1.0}) {
      const auto start =
          flow.drawn(top, side * off * size_ * stability.mode,
                     Eigen::VectorXd::Constant(stability.mode.size(),
                                               100 * std::abs(stability.smallest_eigenvalue)));
      if (!start) return false;
      const Descent descent = let_go(flow, *start);
      const auto end = end_of(descent);
      if (!end) return false;
      (side < 0 ? pass.from : pass.to) = *end;
      for (const FlowPose& pose : descent.poses) way.push_back(way_pose(pose));
      way.push_back({rest(*end).state, rest(*end).tensions, rest(*end).energy});
      if (side > 0) continue;
      std::ranges::reverse(way);
      pass.top = static_cast<int>(way.size());
      way.push_back(way_pose(top));
    }
    if (pass.from == pass.to) return false;
    look_at_strands(pass);
    result_.passes.push_back(std::move(pass));
    return true;
  }

  static WayPose way_pose(const FlowPose& pose) {
    return {pose.state, pose.forces.tension.cwiseMax(0), pose.energy};
  }

  void look_at_strands(Pass& pass) const {
    for (std::size_t k = 0; k < pass.way.size(); ++k) {
      const model::State& state = pass.way[k].state;
      const auto closest = certify::closest(structure_, state);
      if (closest.rods) pass.strands_apart = std::min(pass.strands_apart, closest.rods->distance);
      if (closest.cable_rod && closest.cable_rod->distance < 0)
        pass.cable_in_rod = closest.cable_rod->cable;
      if (k == 0 || pass.strands_met) continue;
      const model::State& before = pass.way[k - 1].state;
      pass.strands_met = certify::strands_meet(structure_, model::positions_of(before),
                                               fitted(structure_, state, before));
    }
  }

  const model::Structure& structure_;
  const RestsOptions& options_;
  bool held_ = false;  // in its place
  double size_ = 0.0;
  std::map<std::pair<int, int>, int> tried_{};  // per two rests, how often a pass was looked for
  Rests result_{};
};

}  // namespace

void RestsOptions::validate() const {
  core::require(directions >= 1, "RestsOptions::directions must be at least 1");
  core::require(reach > 0 && std::isfinite(reach), "RestsOptions::reach must be positive");
  core::require(most_rests >= 1, "RestsOptions::most_rests must be at least 1");
}

Rests find_rests(const model::Structure& structure, const model::State& state,
                 const Eigen::VectorXd& tensions, const RestsOptions& options) {
  options.validate();
  core::require(tensions.size() == static_cast<Eigen::Index>(structure.cables.size()) &&
                    (tensions.size() == 0 || tensions.minCoeff() >= 0),
                "find_rests: needs one tension >= 0 per cable");
  return Finder(structure, options).run(state, tensions);
}

std::vector<std::vector<int>> lowest_ways(const Rests& rests, int from) {
  const std::size_t count = rests.rests.size();
  core::require(from >= 0 && static_cast<std::size_t>(from) < count,
                "lowest_ways: there is no such rest");
  std::vector<std::vector<int>> ways(count);
  std::vector<bool> reached(count, false);
  reached[static_cast<std::size_t>(from)] = true;
  // Always over the lowest pass that leads on: passes are in order of their energies.
  for (bool grows = true; grows;) {
    grows = false;
    for (std::size_t p = 0; p < rests.passes.size() && !grows; ++p) {
      const auto a = static_cast<std::size_t>(rests.passes[p].from);
      const auto b = static_cast<std::size_t>(rests.passes[p].to);
      if (reached[a] == reached[b]) continue;
      const auto known = reached[a] ? a : b, next = reached[a] ? b : a;
      ways[next] = ways[known];
      ways[next].push_back(static_cast<int>(p));
      reached[next] = grows = true;
    }
  }
  return ways;
}

}  // namespace tencer::motion
