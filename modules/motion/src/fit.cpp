#include "fit.hpp"

#include <tencer/model/target.hpp>
#include <tencer/sensitivity/distance.hpp>

namespace tencer::motion {

Positions fitted(const model::Structure& structure, const model::State& state,
                 const model::State& to) {
  const auto deviation =
      sensitivity::deviation(model::make_target(structure, model::positions_of(to)), state);
  const Eigen::Matrix3d back = deviation.motion.rotation.transpose();
  Positions positions = model::positions_of(state);
  for (auto& rod : positions) rod = back * (rod.colwise() - deviation.motion.translation);
  return positions;
}

double distance(const model::Structure& structure, const model::State& from,
                const model::State& to) {
  return sensitivity::deviation(model::make_target(structure, model::positions_of(from)), to).max;
}

}  // namespace tencer::motion
