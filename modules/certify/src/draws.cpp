#include <algorithm>
#include <tencer/certify/draws.hpp>
#include <tencer/equilibrium/constrained.hpp>
#include <tencer/equilibrium/path.hpp>
#include <tencer/sensitivity/distance.hpp>
#include <tencer/sensitivity/parameters.hpp>

namespace tencer::certify {
namespace {

// Errors of all cables, slack ones too.
std::vector<springs::Parameter> all_parameters(const std::vector<springs::Cable>& cables) {
  std::vector<springs::Parameter> parameters;
  for (int c = 0; c < static_cast<int>(cables.size()); ++c)
    for (const auto& parameter : parameters_of(cables[c], c)) parameters.push_back(parameter);
  return parameters;
}

}  // namespace

std::vector<Draw> settle_draws(const model::Structure& structure, const model::State& state,
                               const Eigen::VectorXd& tensions, const CableErrors& errors,
                               int draws, std::uint64_t seed, const std::stop_token& stop) {
  constexpr double least_length = 1e-6;
  const auto parameters = all_parameters(structure.cables);
  const Eigen::MatrixXd units = unit_draws(static_cast<int>(parameters.size()), draws, seed);
  const Eigen::VectorXd exact = sensitivity::values(structure.cables, parameters);
  std::vector<Eigen::Matrix3Xd> pose;
  for (const auto& rod : state) pose.push_back(rod.x);
  const model::Target target = model::make_target(structure, std::move(pose));
  std::vector<Draw> result;
  for (int draw = 0; draw < draws && !stop.stop_requested(); ++draw) {
    Eigen::VectorXd values = exact;
    for (Eigen::Index p = 0; p < values.size(); ++p) {
      values[p] += limit_of(errors, parameters[p]) * units(p, draw);
      if (parameters[p].kind == springs::ParameterKind::rest_length)
        values[p] = std::max(values[p], least_length * exact[p]);
    }
    model::Structure built = structure;
    built.cables = sensitivity::with_values(std::move(built.cables), parameters, values);
    const auto found = equilibrium::settle_along(built, state, tensions, {.solve = {.stop = stop}});
    Draw& one = result.emplace_back();
    one.rests = found.rest.equilibrium.usable();
    one.deviation = sensitivity::deviation(target, found.rest.equilibrium.state).max;
    one.followed = found.held;
    one.falls_at = found.fold_at;
  }
  return result;
}

FirstFall first_fall(const model::Structure& structure, const model::State& state,
                     const Eigen::VectorXd& tensions, const CableErrors& errors,
                     const std::vector<Draw>& once, std::uint64_t seed, double most,
                     const std::stop_token& stop) {
  FirstFall result;
  std::vector<Draw> draws = once;
  for (double times = 1; !stop.stop_requested() && std::ranges::all_of(draws, &Draw::followed);) {
    for (const Draw& draw : draws)
      if (draw.falls_at)
        result.times = std::min(times * *draw.falls_at, result.times.value_or(times));
    result.looked_to = times;
    times *= 2;
    if (result.times || times > most) break;
    draws = settle_draws(structure, state, tensions,
                         {.length = times * errors.length, .attachment = times * errors.attachment},
                         static_cast<int>(once.size()), seed, stop);
  }
  return result;
}

}  // namespace tencer::certify
