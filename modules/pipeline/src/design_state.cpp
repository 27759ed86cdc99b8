#include <algorithm>
#include <tencer/der/energy.hpp>
#include <tencer/equilibrium/frames.hpp>
#include <tencer/model/frames.hpp>
#include <tencer/pipeline/design_state.hpp>

namespace tencer::pipeline {

model::State target_state(const model::Design& design, const model::Structure& structure,
                          const model::Scaling& scaling) {
  model::State state = make_state(structure, model::scaled(design.target, scaling));
  bool unknown = false;
  for (std::size_t r = 0; r < state.size(); ++r) {
    if (design.target_directors[r].cols() > 0) {
      model::set_frames(state[r], design.target_directors[r]);
    } else {
      model::turn_to_least_energy(structure.rods[r], state[r]);
      unknown = true;
    }
  }
  if (unknown) equilibrium::relax_frames(structure, state);
  return state;
}

model::State pose_state(const model::Design& design, const model::Structure& structure,
                        const model::Scaling& scaling) {
  const auto poses = model::scaled(design.pose, scaling);
  model::State state = make_state(structure, poses);
  const auto twists = [](const der::Rod& rod) {
    return der::twist_model(rod) != der::TwistModel::none;
  };
  if (std::ranges::none_of(structure.rods, twists)) return state;
  model::State carried = target_state(design, structure, scaling);
  for (std::size_t r = 0; r < state.size(); ++r) {
    const der::Rod& rod = structure.rods[r];
    if (!twists(rod)) continue;
    Eigen::VectorXd step = Eigen::VectorXd::Zero(der::unknowns(rod));
    step.head(poses[r].size()) = (poses[r] - carried[r].x).reshaped();
    der::displace(rod, carried[r], step);
    if (design.pose_directors[r].cols() > 0)
      model::set_frames(carried[r], design.pose_directors[r]);
    state[r] = carried[r];
  }
  return state;
}

}  // namespace tencer::pipeline
