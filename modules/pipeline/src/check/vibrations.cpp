#include <tencer/certify/modes.hpp>
#include <tencer/pipeline/vibrations.hpp>

#include "check/pose.hpp"

namespace tencer::pipeline {

std::vector<Vibration> vibrations(const model::Design& design, int count) {
  const RestPose pose = rest_pose(design);
  const auto modes = certify::vibration_modes(pose.structure, pose.state, pose.tensions,
                                              mass_per_length(pose), count);
  std::vector<Vibration> result;
  if (!modes.computed) return result;
  for (Eigen::Index i = 0; i < modes.hertz.size(); ++i)
    result.push_back({modes.hertz[i], modes.shapes[static_cast<std::size_t>(i)]});
  return result;
}

}  // namespace tencer::pipeline
