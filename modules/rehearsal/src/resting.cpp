#include "resting.hpp"

#include <tencer/model/frames.hpp>
#include <tencer/model/target.hpp>
#include <tencer/pipeline/design_state.hpp>
#include <tencer/pipeline/simulate.hpp>
#include <tencer/sensitivity/distance.hpp>
#include <utility>

namespace tencer::rehearsal {

std::optional<Resting> resting(const model::Design& design, const std::stop_token& stop) {
  auto rest = pipeline::simulate(design, {.solve = {.stop = stop}});
  if (!rest || !rest->stays()) return std::nullopt;
  Resting result{.design = std::move(rest->design),
                 .scaling = model::scaling_of(design.structure, design.target)};
  auto& built = result.design.built;
  for (std::size_t c = 0; c < built.size(); ++c)  // slack cables are longer than they look
    if (!(built[c].tension > 0)) built[c].length = design.built[c].length;
  result.structure = model::scaled(model::as_built(result.design), result.scaling);
  result.state = pipeline::pose_state(result.design, result.structure, result.scaling);
  result.tensions.resize(static_cast<Eigen::Index>(built.size()));
  for (std::size_t c = 0; c < built.size(); ++c)
    result.tensions[static_cast<Eigen::Index>(c)] = built[c].tension / result.scaling.scale.force();
  return result;
}

Fitted fitted(const Resting& resting, const model::State& state,
              const std::vector<Eigen::Matrix3Xd>& onto) {
  const auto deviation = sensitivity::deviation(
      model::make_target(resting.structure, model::scaled(onto, resting.scaling)), state);
  const Eigen::Matrix3d back = deviation.motion.rotation.transpose();
  Fitted result;
  for (const auto& rod : state) {
    result.pose.push_back(
        resting.scaling.unscaled(back * (rod.x.colwise() - deviation.motion.translation)));
    result.directors.push_back(back * model::directors(rod));
  }
  return result;
}

}  // namespace tencer::rehearsal
