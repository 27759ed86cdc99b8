#include "variables.hpp"

#include <algorithm>
#include <cmath>

namespace tencer::sparsify {
namespace {

// How far an attachment may slide in a round, in edges, and how much a stiffness may grow.
constexpr double slide_range = 6.0;
constexpr double growth = 3.0;
// Without sparsity no stiffness shall vanish: the least root, relative to that at the start.
constexpr double min_root = 0.1;

void add_position(const network::Network& network, const model::Rules& rules, int cable,
                  springs::ParameterKind kind, std::vector<Variable>& variables) {
  const auto& structure = network.structure;
  const auto& end = kind == springs::ParameterKind::position_a ? structure.cables[cable].a
                                                               : structure.cables[cable].b;
  const auto* on = std::get_if<springs::OnRod>(&end);
  if (!on) return;
  const double edge = structure.rods[on->rod].rest_lengths.mean();
  const model::Interval free = sliding_interval(rules, structure, on->rod, on->s);
  variables.push_back({.parameter = {kind, cable},
                       .scale = edge,
                       .lower = std::max(free.lower / edge, on->s / edge - slide_range),
                       .upper = std::min(free.upper / edge, on->s / edge + slide_range)});
}

}  // namespace

std::vector<Variable> design_variables(const network::Network& network, const RoundsSetup& setup,
                                       double rest_ratio) {
  std::vector<Variable> variables;
  const auto& cables = network.structure.cables;
  const bool sparse = setup.external > 0 || setup.internal > 0;
  double strongest = 0;
  for (const auto& cable : cables) strongest = std::max(strongest, std::sqrt(cable.stiffness));
  for (int i = 0; i < static_cast<int>(cables.size()); ++i) {
    Variable variable{.parameter = {springs::ParameterKind::stiffness, i}};
    // With sparsity the weak are next to zero and reach it first; without, all move alike.
    variable.scale = sparse ? std::sqrt(setup.reference / (1 - rest_ratio))
                            : std::max(std::sqrt(cables[i].stiffness), 0.1 * strongest);
    variable.sparsity = weight_of(cables[i], setup);
    variable.lower = sparse ? 0.0 : min_root * std::sqrt(cables[i].stiffness) / variable.scale;
    variable.upper = growth * strongest / variable.scale;
    variables.push_back(variable);
  }
  if (setup.slide)
    for (int i = 0; i < static_cast<int>(cables.size()); ++i) {
      add_position(network, setup.rules, i, springs::ParameterKind::position_a, variables);
      add_position(network, setup.rules, i, springs::ParameterKind::position_b, variables);
    }
  return variables;
}

}  // namespace tencer::sparsify
