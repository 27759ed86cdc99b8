#include "model/local_model.hpp"

#include <algorithm>
#include <tencer/certify/tolerance.hpp>
#include <tencer/core/error.hpp>
#include <tencer/springs/derivatives.hpp>
#include <tencer/springs/law.hpp>
#include <tencer/symmetry/tie.hpp>

namespace tencer::elimination {
namespace {

using springs::ParameterKind;

// parameters, ties, orbits and what the variables are.
void lay_out(const std::vector<springs::Cable>& cables, const symmetry::Group* group,
             int fixed_cables, LocalModel& model) {
  model.parameters = cable_parameters(cables, fixed_cables);
  const auto size = static_cast<Eigen::Index>(model.parameters.size());
  std::vector<springs::Parameter> free = model.parameters;
  if (group) {
    const symmetry::Ties ties = symmetry::tie_cables(cables, *group, ParameterKind::rest_length);
    model.ties = ties.matrix;
    free = ties.free;
    if (!cables.empty()) model.orbits.resize(1 + *std::ranges::max_element(ties.orbit));
    for (int c = 0; c < static_cast<int>(cables.size()); ++c)
      model.orbits[ties.orbit[c]].push_back(c);
  } else {
    model.ties.resize(size, size);
    model.ties.setIdentity();
    for (int c = fixed_cables; c < static_cast<int>(cables.size()); ++c)
      model.orbits.push_back({c});
  }
  for (int z = 0; z < static_cast<int>(free.size()); ++z) {
    const auto& cable = cables[free[z].cable];
    if (free[z].kind == ParameterKind::rest_length)
      model.rest_lengths.push_back(z);
    else
      model.positions.push_back(
          {z, std::get<springs::OnRod>(free[z].kind == ParameterKind::position_a ? cable.a
                                                                                 : cable.b)});
  }
}

// Fills length_rates for the first cable of each orbit.
void add_length_rates(const sensitivity::Configuration& at, LocalModel& model) {
  const auto orbits = static_cast<Eigen::Index>(model.orbits.size());
  model.length.resize(orbits);
  model.length_rates = Eigen::MatrixXd::Zero(orbits, model.ties.cols());
  const Eigen::SparseMatrix<double, Eigen::RowMajor> ties = model.ties;
  std::vector<int> first_parameter(at.cables().size());
  for (int i = static_cast<int>(model.parameters.size()) - 1; i >= 0; --i)
    first_parameter[model.parameters[i].cable] = i;
  for (Eigen::Index o = 0; o < orbits; ++o) {
    const int c = model.orbits[o].front();
    const auto& stencil = at.system.stencils()[c];
    const Eigen::Vector3d span = model::span_of(stencil, at.state);
    model.length[o] = span.norm();
    const Eigen::Vector3d direction = span / model.length[o];
    at.system.for_each_unknown(stencil, [&](int row, int axis, double weight) {
      model.length_rates.row(o) += weight * direction[axis] * model.motion.row(row);
    });
    for (std::size_t p = first_parameter[c];
         p < model.parameters.size() && model.parameters[p].cable == c; ++p) {
      const ParameterKind kind = model.parameters[p].kind;
      if (kind == ParameterKind::rest_length) continue;
      const auto rates = springs::weight_rates(
          at.cables()[c], stencil, at.system.arc_lengths(),
          kind == ParameterKind::position_a ? springs::Attachment::a : springs::Attachment::b);
      double slope = 0;
      for (int i = 0; i < stencil.count; ++i)
        slope += rates[i] *
                 direction.dot(at.state[stencil.shares[i].rod].x.col(stencil.shares[i].vertex));
      model.length_rates.row(o) += slope * ties.row(static_cast<Eigen::Index>(p));
    }
  }
}

}  // namespace

std::vector<springs::Parameter> cable_parameters(const std::vector<springs::Cable>& cables,
                                                 int fixed_cables) {
  std::vector<springs::Parameter> parameters;
  for (int c = fixed_cables; c < static_cast<int>(cables.size()); ++c)
    for (const auto& parameter : certify::parameters_of(cables[c], c))
      parameters.push_back(parameter);
  return parameters;
}

LocalModel local_model(const sensitivity::Configuration& at, const model::Target& target,
                       const symmetry::Group* group, int fixed_cables) {
  core::require(!group || fixed_cables == 0, "local_model: no cables are fixed with a group");
  LocalModel model;
  lay_out(at.cables(), group, fixed_cables, model);
  model.motion = sensitivity::state_derivatives(at, model.parameters, model.ties);
  model.distance =
      sensitivity::least_squares(sensitivity::Distance(target, at.system, at.state), model.motion);
  add_length_rates(at, model);
  // q = k (1 - l / |d|)
  const auto orbits = static_cast<Eigen::Index>(model.orbits.size());
  model.density.resize(orbits);
  model.density_rates = model.length_rates;
  for (Eigen::Index o = 0; o < orbits; ++o) {
    const auto& cable = at.cables()[model.orbits[o].front()];
    const double length = model.length[o];
    model.density[o] = springs::tension(cable, length) / length;
    model.density_rates.row(o) *= cable.stiffness * cable.rest_length / (length * length);
    model.density_rates(o, model.rest_lengths[o]) -= cable.stiffness / length;
  }
  return model;
}

}  // namespace tencer::elimination
