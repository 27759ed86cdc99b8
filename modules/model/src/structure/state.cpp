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

std::vector<Eigen::Matrix3Xd> positions_of(const State& state) {
  std::vector<Eigen::Matrix3Xd> positions;
  for (const auto& rod : state) positions.push_back(rod.x);
  return positions;
}

Eigen::Matrix3Xd cable_ends(const Structure& structure,
                            const std::vector<Eigen::Matrix3Xd>& positions) {
  const auto along = arc_lengths(structure);
  const auto point = [&](const springs::End& end) -> Eigen::Vector3d {
    if (const auto* anchor = std::get_if<springs::AtAnchor>(&end))
      return structure.anchors.col(anchor->anchor);
    const auto& on = std::get<springs::OnRod>(end);
    const auto [edge, t] = along[on.rod].locate(on.s);
    const auto& x = positions[on.rod];
    return (1 - t) * x.col(edge) + t * x.col((edge + 1) % x.cols());
  };
  const auto count = static_cast<Eigen::Index>(structure.cables.size());
  Eigen::Matrix3Xd ends(3, 2 * count);
  for (Eigen::Index i = 0; i < count; ++i) {
    ends.col(2 * i) = point(structure.cables[i].a);
    ends.col(2 * i + 1) = point(structure.cables[i].b);
  }
  return ends;
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
