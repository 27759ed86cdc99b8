#include <tencer/core/error.hpp>
#include <tencer/model/state.hpp>

namespace tencer::model {

State make_state(const Structure& structure, const std::vector<Eigen::Matrix3Xd>& positions) {
  core::require(positions.size() == structure.rods.size(),
                "make_state: needs the positions of every rod");
  State state;
  for (std::size_t r = 0; r < positions.size(); ++r)
    state.push_back(der::make_state(structure.rods[r], positions[r]));
  return state;
}

Eigen::Vector3d span_of(const springs::Stencil& stencil, const State& state) {
  return springs::span_of(stencil, [&](int rod, int vertex) { return state[rod].x.col(vertex); });
}

Eigen::VectorXd cable_lengths(const Structure& structure, const State& state) {
  const auto along = arc_lengths(structure);
  Eigen::VectorXd lengths(static_cast<Eigen::Index>(structure.cables.size()));
  for (Eigen::Index i = 0; i < lengths.size(); ++i)
    lengths[i] =
        span_of(springs::stencil(structure.cables[i], along, structure.anchors), state).norm();
  return lengths;
}

}  // namespace tencer::model
