#include <algorithm>
#include <cmath>
#include <functional>
#include <tencer/certify/shoves.hpp>
#include <tencer/sensitivity/distance.hpp>

#include "check/pose.hpp"

namespace tencer::pipeline {
namespace {

// Other stable poses, each once.
class Others {
 public:
  Others(const RestPose& pose, double same) : pose_(pose), same_(same) {}

  void add(const certify::PushedRest& rest) {
    std::vector<Eigen::Matrix3Xd> points;
    for (const auto& rod : rest.state) points.push_back(rod.x);
    const auto target = model::make_target(pose_.structure, points);
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
  constexpr int smooth = 6, rough = 24;  // modes
  constexpr double same_percent = 0.1;
  const double percent = size_of(pose.design) / pose.scaling.scale.length / 100;
  const auto modes = certify::vibration_modes(pose.structure, pose.state, pose.tensions,
                                              mass_per_length(pose), rough);
  if (!modes.computed) return std::nullopt;
  Others others(pose, same_percent * percent);
  model::ComesBack result;
  for (const double size : {1.0, 2.0, 5.0}) {
    model::Pushes& pushes = result.pushes.emplace_back();
    pushes.size = size / 100 * size_of(pose.design);
    for (int i = 0; i < tries && !options.stop.stop_requested(); ++i) {
      const auto rest =
          certify::push_and_release(pose.structure, pose.state, modes,
                                    {.size = size * percent,
                                     .modes = i % 2 == 0 ? smooth : rough,
                                     .seed = options.seed + static_cast<std::uint64_t>(i)},
                                    options.stop);
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

}  // namespace tencer::pipeline
