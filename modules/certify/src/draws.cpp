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

// A pose and what is built wrong.
struct Built {
  const model::Structure& structure;
  const model::State& state;
  const Eigen::VectorXd& tensions;
  const model::Target& pose;
  const std::vector<springs::Parameter>& parameters;
  const Eigen::VectorXd& errors;  // per parameter

  model::Structure with(double part) const {
    constexpr double least_length = 1e-6;
    const Eigen::VectorXd exact = sensitivity::values(structure.cables, parameters);
    Eigen::VectorXd values = exact + part * errors;
    for (Eigen::Index p = 0; p < values.size(); ++p)
      if (parameters[p].kind == springs::ParameterKind::rest_length)
        values[p] = std::max(values[p], least_length * exact[p]);
    model::Structure result = structure;
    result.cables = sensitivity::with_values(std::move(result.cables), parameters, values);
    return result;
  }
};

// In equal stages from no errors to all. Within a stage the places where cables are tied jump, and
// the forces that then lack fade.
Draw follow(const Built& built, int stages, const std::stop_token& stop) {
  model::State state = built.state;
  Eigen::VectorXd tensions = built.tensions;
  Draw draw;
  for (int k = 0; k < stages && draw.rests && draw.followed && !draw.falls_at; ++k) {
    auto found = equilibrium::settle_along(built.with((k + 1.0) / stages), std::move(state),
                                           tensions, {.solve = {.stop = stop}});
    draw.rests = found.rest.equilibrium.usable();
    draw.followed = found.held;
    if (found.fold_at) draw.falls_at = (k + *found.fold_at) / stages;
    state = std::move(found.rest.equilibrium.state);
    tensions = found.rest.tensions.cwiseMax(0);
  }
  draw.deviation = sensitivity::deviation(built.pose, state).max;
  return draw;
}

// All at once, or in so many stages that a jump of the places is not taken for a fall.
Draw settle(const Built& built, bool places_move, const std::stop_token& stop) {
  Draw draw = follow(built, 1, stop);
  for (const int stages : {4, 16})
    if (places_move && (!draw.rests || !draw.followed || draw.falls_at))
      draw = follow(built, stages, stop);
  return draw;
}

}  // namespace

std::vector<Draw> settle_draws(const model::Structure& structure, const model::State& state,
                               const Eigen::VectorXd& tensions, const CableErrors& errors,
                               int draws, std::uint64_t seed, const std::stop_token& stop) {
  const auto parameters = all_parameters(structure.cables);
  const Eigen::MatrixXd units = unit_draws(static_cast<int>(parameters.size()), draws, seed);
  Eigen::VectorXd limits(units.rows());
  for (Eigen::Index p = 0; p < limits.size(); ++p) limits[p] = limit_of(errors, parameters[p]);
  std::vector<Eigen::Matrix3Xd> points;
  for (const auto& rod : state) points.push_back(rod.x);
  const model::Target pose = model::make_target(structure, std::move(points));
  std::vector<Draw> result;
  for (int draw = 0; draw < draws && !stop.stop_requested(); ++draw) {
    const Eigen::VectorXd wrong = limits.cwiseProduct(units.col(draw));
    result.push_back(
        settle({structure, state, tensions, pose, parameters, wrong}, errors.attachment > 0, stop));
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
