#include "local_model.hpp"

#include <algorithm>
#include <tencer/core/error.hpp>
#include <tencer/springs/derivatives.hpp>
#include <tencer/springs/law.hpp>
#include <tencer/symmetry/tie.hpp>

namespace tencer::sparsify {
namespace {

using sensitivity::Kind;

Kind kind_of(symmetry::Kind kind) {
  if (kind == symmetry::Kind::position_a) return Kind::position_a;
  return kind == symmetry::Kind::position_b ? Kind::position_b : Kind::rest_length;
}

std::vector<sensitivity::Parameter> all_parameters(const std::vector<springs::Cable>& cables,
                                                   int kept) {
  std::vector<sensitivity::Parameter> parameters;
  for (int c = kept; c < static_cast<int>(cables.size()); ++c) {
    parameters.push_back({Kind::rest_length, c});
    if (std::holds_alternative<springs::OnRod>(cables[c].a))
      parameters.push_back({Kind::position_a, c});
    if (std::holds_alternative<springs::OnRod>(cables[c].b))
      parameters.push_back({Kind::position_b, c});
  }
  return parameters;
}

// parameters, ties, orbits and what the variables are.
void lay_out(const std::vector<springs::Cable>& cables, const symmetry::Group* group, int kept,
             LocalModel& model) {
  model.parameters = all_parameters(cables, kept);
  const auto size = static_cast<Eigen::Index>(model.parameters.size());
  std::vector<sensitivity::Parameter> free = model.parameters;
  if (group) {
    const symmetry::Ties ties = symmetry::tie_cables(cables, *group);
    model.ties = ties.matrix;
    free.clear();
    for (const auto& parameter : ties.free)
      free.push_back({kind_of(parameter.kind), parameter.cable});
    if (!cables.empty()) model.orbits.resize(1 + *std::ranges::max_element(ties.orbit));
    for (int c = 0; c < static_cast<int>(cables.size()); ++c)
      model.orbits[ties.orbit[c]].push_back(c);
  } else {
    model.ties.resize(size, size);
    model.ties.setIdentity();
    for (int c = kept; c < static_cast<int>(cables.size()); ++c) model.orbits.push_back({c});
  }
  for (int z = 0; z < static_cast<int>(free.size()); ++z) {
    const auto& cable = cables[free[z].cable];
    if (free[z].kind == Kind::rest_length)
      model.rest_lengths.push_back(z);
    else
      model.positions.push_back(
          {z, std::get<springs::OnRod>(free[z].kind == Kind::position_a ? cable.a : cable.b)});
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
    const Eigen::Vector3d span = equilibrium::span_of(stencil, at.state);
    model.length[o] = span.norm();
    const Eigen::Vector3d direction = span / model.length[o];
    for (int i = 0; i < stencil.count; ++i) {
      const auto& share = stencil.shares[i];
      for (int axis = 0; axis < 3; ++axis)
        if (const int row = at.system.position_index(share.rod, share.vertex, axis); row >= 0)
          model.length_rates.row(o) += share.weight * direction[axis] * model.motion.row(row);
    }
    for (std::size_t p = first_parameter[c];
         p < model.parameters.size() && model.parameters[p].cable == c; ++p) {
      const Kind kind = model.parameters[p].kind;
      if (kind == Kind::rest_length) continue;
      const auto rates = springs::weight_rates(
          at.cables()[c], stencil, at.system.arc_lengths(),
          kind == Kind::position_a ? springs::Attachment::a : springs::Attachment::b);
      double slope = 0;
      for (int i = 0; i < stencil.count; ++i)
        slope += rates[i] *
                 direction.dot(at.state[stencil.shares[i].rod].x.col(stencil.shares[i].vertex));
      model.length_rates.row(o) += slope * ties.row(static_cast<Eigen::Index>(p));
    }
  }
}

}  // namespace

LocalModel local_model(const sensitivity::Configuration& at, const sensitivity::Target& target,
                       const symmetry::Group* group, int kept) {
  core::require(!group || kept == 0, "local_model: keeps no cables with a group");
  LocalModel model;
  lay_out(at.cables(), group, kept, model);
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

}  // namespace tencer::sparsify
