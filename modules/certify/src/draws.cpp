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
  const equilibrium::PathOptions& options;

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
Draw follow(const Built& built, int stages) {
  model::State state = built.state;
  Eigen::VectorXd tensions = built.tensions;
  Draw draw;
  for (int k = 0; k < stages && draw.rests && draw.followed && !draw.falls_at; ++k) {
    auto found = equilibrium::settle_along(built.with((k + 1.0) / stages), std::move(state),
                                           tensions, built.options);
    draw.rests = found.rest.equilibrium.usable();
    draw.followed = found.held;
    if (found.fold_at) draw.falls_at = (k + *found.fold_at) / stages;
    if (!draw.rests) return draw;
    state = std::move(found.rest.equilibrium.state);
    tensions = found.rest.tensions.cwiseMax(0);
  }
  draw.deviation = sensitivity::deviation(built.pose, state).max;
  return draw;
}

// All at once; a fall is one only if it is also one in so many stages that the places jump little,
// and that no step comes down on another branch of poses close by.
Draw settle(const Built& built) {
  Draw draw = follow(built, 1);
  for (const int stages : {4, 16})
    if (!draw.keeps_its_path()) draw = follow(built, stages);
  return draw;
}

// Draws one after the other, until visit(draw) is false.
template <class Visit>
void each_draw(const model::Structure& structure, const model::State& state,
               const Eigen::VectorXd& tensions, const CableErrors& errors, int draws,
               std::uint64_t seed, const equilibrium::PathOptions& options,
               const std::vector<model::View>& views, Visit&& visit) {
  const auto parameters = all_parameters(structure.cables);
  const Eigen::MatrixXd units = unit_draws(static_cast<int>(parameters.size()), draws, seed);
  Eigen::VectorXd limits(units.rows());
  for (Eigen::Index p = 0; p < limits.size(); ++p) limits[p] = limit_of(errors, parameters[p]);
  model::Target pose = model::make_target(structure, model::positions_of(state));
  pose.views = views;
  for (int draw = 0; draw < draws && !options.solve.stop.stop_requested(); ++draw) {
    const Eigen::VectorXd wrong = limits.cwiseProduct(units.col(draw));
    if (!visit(settle({structure, state, tensions, pose, parameters, wrong, options}))) return;
  }
}

}  // namespace

std::vector<Draw> settle_draws(const model::Structure& structure, const model::State& state,
                               const Eigen::VectorXd& tensions, const CableErrors& errors,
                               int draws, std::uint64_t seed, const std::stop_token& stop,
                               const std::vector<model::View>& views) {
  std::vector<Draw> result;
  each_draw(structure, state, tensions, errors, draws, seed, {.solve = {.stop = stop}}, views,
            [&](const Draw& draw) {
              result.push_back(draw);
              return true;
            });
  return result;
}

bool all_keep_their_paths(const model::Structure& structure, const model::State& state,
                          const Eigen::VectorXd& tensions, const CableErrors& errors, int draws,
                          std::uint64_t seed, const std::stop_token& stop) {
  bool all = true;
  each_draw(structure, state, tensions, errors, draws, seed,
            {.beyond_fold = false, .solve = {.stop = stop}}, {}, [&](const Draw& draw) {
              all = draw.keeps_its_path();
              return all;
            });
  return all && !stop.stop_requested();
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
