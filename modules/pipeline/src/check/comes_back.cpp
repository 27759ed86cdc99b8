#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <tencer/certify/shoves.hpp>
#include <tencer/pipeline/shoves.hpp>
#include <tencer/sensitivity/distance.hpp>

#include "check/pose.hpp"

namespace tencer::pipeline {
namespace {

constexpr int smooth = 6, rough = 24;       // modes of a push
constexpr std::array sizes{1.0, 2.0, 5.0};  // of a push, in % of the size
constexpr double same_percent = 0.1;        // of the size

// Push number i: smooth and rough by turns.
certify::Push push_of(int i, double size, std::uint64_t seed) {
  return {.size = size,
          .modes = i % 2 == 0 ? smooth : rough,
          .seed = seed + static_cast<std::uint64_t>(i)};
}

certify::VibrationModes modes_of(const RestPose& pose) {
  return certify::vibration_modes(pose.structure, pose.state, pose.tensions, mass_per_length(pose),
                                  rough);
}

// A percent of the size, scaled.
double percent_of(const RestPose& pose) {
  return size_of(pose.design) / pose.scaling.scale.length / 100;
}

// So many of them at most, the first and the last among them.
template <class T>
std::vector<T> thinned(std::vector<T> all, std::size_t most) {
  if (all.size() <= most) return all;
  std::vector<T> result;
  for (std::size_t i = 0; i < most; ++i)
    result.push_back(std::move(all[i * (all.size() - 1) / (most - 1)]));
  return result;
}

// Other stable poses, each once.
class Others {
 public:
  Others(const RestPose& pose, double same) : pose_(pose), same_(same) {}

  void add(const certify::PushedRest& rest) {
    const auto target = model::make_target(pose_.structure, model::positions_of(rest.state));
    for (std::size_t i = 0; i < states_.size(); ++i)
      if (sensitivity::deviation(target, states_[i]).max < same_) {
        ++found_[i].times;
        return;
      }
    states_.push_back(rest.state);
    found_.push_back({.distance = rest.deviation * pose_.scaling.scale.length,
                      .energy = rest.energy * pose_.scaling.scale.energy,
                      .times = 1});
  }

  const std::vector<model::OtherPose>& found() const { return found_; }

 private:
  const RestPose& pose_;
  double same_;
  std::vector<model::State> states_;
  std::vector<model::OtherPose> found_;
};

}  // namespace

std::optional<model::ComesBack> comes_back(const RestPose& pose, const CheckOptions& options) {
  constexpr int tries = 20;
  const double percent = percent_of(pose);
  const auto modes = modes_of(pose);
  if (!modes.computed) return std::nullopt;
  Others others(pose, same_percent * percent);
  model::ComesBack result;
  for (const double size : sizes) {
    model::Pushes& pushes = result.pushes.emplace_back();
    pushes.size = size / 100 * size_of(pose.design);
    for (int i = 0; i < tries && !options.stop.stop_requested(); ++i) {
      const auto rest =
          certify::push_and_release(pose.structure, pose.state, modes,
                                    push_of(i, size * percent, options.seed), options.stop);
      ++pushes.tried;
      if (!rest.rests) {
        ++pushes.lost;
      } else if (rest.deviation < same_percent * percent) {
        ++pushes.back;
        pushes.strands_met += rest.strands_met ? 1 : 0;
      } else {
        others.add(rest);
      }
    }
  }
  result.others = others.found();
  std::ranges::stable_sort(result.others, std::greater{}, &model::OtherPose::times);
  return result;
}

std::vector<Shove> shoves(const model::Design& design) {
  constexpr std::size_t most_poses = 8;
  const RestPose pose = rest_pose(design);
  const double percent = percent_of(pose);
  const auto modes = modes_of(pose);
  std::vector<Shove> result;
  if (!modes.computed || modes.shapes.empty()) return result;
  for (const int i : {0, 1}) {
    const certify::Push push = push_of(i, sizes.back() * percent, CheckOptions{}.seed);
    const auto rest = certify::push_and_release(pose.structure, pose.state, modes, push);
    Shove& shove =
        result.emplace_back(Shove{.size = push.size * pose.scaling.scale.length,
                                  .smooth = push.modes == smooth,
                                  .rests = rest.rests,
                                  .away = rest.deviation * pose.scaling.scale.length,
                                  .back = rest.rests && rest.deviation < same_percent * percent});
    for (auto& at : thinned(certify::way_of(pose.structure, pose.state, modes, push), most_poses)) {
      for (auto& rod : at) rod = pose.scaling.unscaled(rod);
      shove.poses.push_back(std::move(at));
    }
  }
  return result;
}

}  // namespace tencer::pipeline
