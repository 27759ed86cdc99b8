#include "pulling_cables.hpp"

#include <algorithm>

namespace tencer::equilibrium {

Eigen::VectorXd cable_lengths(const System& system, const model::State& state) {
  Eigen::VectorXd lengths(static_cast<Eigen::Index>(system.stencils().size()));
  for (std::size_t c = 0; c < system.stencils().size(); ++c)
    lengths[static_cast<Eigen::Index>(c)] = model::span_of(system.stencils()[c], state).norm();
  return lengths;
}

Eigen::VectorXd gradient_with(const System& system, const model::State& state,
                              const Eigen::VectorXd& tensions) {
  Eigen::VectorXd gradient = system.rod_gradient(state);
  for (std::size_t c = 0; c < system.stencils().size(); ++c) {
    const auto& stencil = system.stencils()[c];
    const Eigen::Vector3d pull =
        tensions[static_cast<Eigen::Index>(c)] * model::span_of(stencil, state).normalized();
    system.for_each_unknown(
        stencil, [&](int at, int axis, double weight) { gradient[at] += weight * pull[axis]; });
  }
  return gradient;
}

double axial_stiffness(const model::Structure& structure) {
  double stiffness = 0;
  for (const auto& rod : structure.rods)
    stiffness = std::max(stiffness, rod.section.EA / rod.length());
  return stiffness;
}

std::optional<std::vector<springs::Cable>> as_springs(const model::Structure& structure,
                                                      const Eigen::VectorXd& tensions,
                                                      double stiffness) {
  std::vector<springs::Cable> springs = structure.cables;
  for (std::size_t c = 0; c < springs.size(); ++c) {
    springs[c].tension_only = true;
    springs[c].stiffness = stiffness;
    springs[c].rest_length -= tensions[static_cast<Eigen::Index>(c)] / stiffness;
    if (!(springs[c].rest_length > 0)) return std::nullopt;
  }
  return springs;
}

}  // namespace tencer::equilibrium
