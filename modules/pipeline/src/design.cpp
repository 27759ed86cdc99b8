#include <algorithm>
#include <tencer/equilibrium/built.hpp>
#include <tencer/pipeline/design.hpp>
#include <tencer/pipeline/prepare.hpp>
#include <tencer/pipeline/simulate.hpp>
#include <utility>

#include "record.hpp"
#include "route.hpp"

namespace tencer::pipeline {
namespace {

void say(const DesignOptions& options, core::Level level, const std::string& text) {
  if (options.log) options.log(level, text);
}

// What is wrong when there are no candidates: the error, with the key without whose rules there
// would be some.
std::string why_no_candidates(const io::Scene& scene, const Prepared& prepared,
                              const core::Error& error) {
  const auto allowed_but_for = [&](auto&& lift) {
    sparsify::Rules rules = prepared.rules;
    lift(rules);
    return sparsify::candidates(prepared.structure, prepared.target.points, rules).has_value();
  };
  using sparsify::Rules;
  if (allowed_but_for([](Rules& rules) { rules.longest = Rules{}.longest; }))
    return "design.longest_cable: " + error.message;
  if (allowed_but_for([](Rules& rules) { rules.pairs.reset(); }))
    return "design.rod_pairs: " + error.message;
  if (allowed_but_for([](Rules& rules) { rules.forbidden.clear(); })) {
    const bool arcs = std::ranges::any_of(
        scene.rods, [](const io::SceneRod& rod) { return !rod.forbidden_arcs.empty(); });
    return std::string(arcs ? "design.forbidden_arcs: " : "design.forbidden_vertices: ") +
           error.message;
  }
  if (!error.where.empty()) return error.message;  // vertices coincide
  return "no cable is possible: the vertices are all neighbours on their rod, or held in place";
}

// The design file with its cables; what depends on the equilibrium is missing.
io::Design file_of(const Prepared& prepared, const sparsify::Network& network) {
  const Units& units = prepared.units;
  io::Design design = prepared.file;
  for (const auto& cable : network.structure.cables)
    design.cables.push_back({.a = file_end(cable.a, network.structure, units),
                             .b = file_end(cable.b, network.structure, units),
                             .stiffness = cable.stiffness * units.scale.stiffness(),
                             .rest_length = cable.rest_length * units.scale.length});
  return design;
}

// Settles the built form from the target and compares with the pose that the design claims.
io::TraceRow check_settling(io::Design& design) {
  const auto simulation = simulate(design, {.start = Start::target});
  io::TraceRow row;
  row.stage = "settle";
  row.cables = static_cast<int>(design.cables.size());
  const Simulation& settled = *simulation;
  row.seconds = settled.seconds;
  row.max_percent = settled.design.error->max_percent;
  row.rms_percent = settled.design.error->rms_percent;
  row.equilibrium_solves = 1;
  row.newton_iterations = settled.iterations;
  design.certificate->settles_from_target = settled.usable() && settled.moved_percent <= 0.01;
  if (!settled.usable())
    row.note = "with inextensible cables, from the target: " + describe(settled.reason);
  else if (!*design.certificate->settles_from_target)
    row.note = "from the target the built form settles elsewhere, " +
               std::to_string(settled.moved_percent) + " % away from the pose";
  return row;
}

// The design of a network: complete unless it falls short of what the settings ask for.
io::Design certified(const io::DesignSettings& settings, const Prepared& prepared,
                     const sparsify::Network& network) {
  io::Design design = file_of(prepared, network);
  record(network.structure, network.state, sparsify::cable_tensions(network), prepared.target,
         prepared.units, design);
  const io::TraceRow row = check_settling(design);
  design.trace.push_back(row);
  const bool close = settings.cables ? static_cast<int>(design.cables.size()) <= *settings.cables
                                     : design.error->max_percent <= settings.max_error;
  design.status = close && design.certificate->stable && *design.certificate->settles_from_target
                      ? io::DesignStatus::complete
                      : io::DesignStatus::tolerance_not_reached;
  return design;
}

// The scene checked and ready, with all candidates, and the networks found.
struct Run {
  Prepared prepared{};
  Outcome outcome{};
};

core::Expected<Run> run(const io::Scene& scene, bool every_number, const DesignOptions& options) {
  const io::DesignSettings& settings = scene.design;
  const auto backend = optimize::find_backend(options.backends, settings.optimizer);
  if (!backend) return core::Error{scene.source, "design.optimizer: " + backend.error().message};
  auto prepared = prepare(scene);
  if (!prepared) return prepared.error();
  for (const Part& part : prepared->parts)
    if (!part.used) say(options, core::Level::debug, "no " + part.name + ": " + part.why);
  const auto candidates =
      sparsify::candidates(prepared->structure, prepared->target.points, prepared->rules);
  if (!candidates)
    return core::Error{scene.source, why_no_candidates(scene, *prepared, candidates.error())};
  Outcome outcome = run_route(settings, *prepared, *candidates, *backend, every_number, options);
  return Run{std::move(*prepared), std::move(outcome)};
}

}  // namespace

core::Expected<io::Design> design(const io::Scene& scene, const DesignOptions& options) {
  auto found = run(scene, false, options);
  if (!found) return found.error();
  auto& [prepared, outcome] = *found;
  const auto& asked = outcome.networks[outcome.asked];
  if (outcome.interrupted) {
    io::Design design = file_of(prepared, asked);
    record(asked.structure, asked.state, sparsify::cable_tensions(asked), prepared.target,
           prepared.units, design);
    design.trace = std::move(outcome.trace);
    design.status = io::DesignStatus::interrupted;
    return design;
  }
  // A network that passes all the tests of the built form is better than one with fewer cables that
  // does not.
  constexpr int tried = 6;
  io::Design design = certified(scene.design, prepared, asked);
  std::vector<io::TraceRow> checks = design.trace;
  const int step = scene.design.cables ? -1 : 1;
  for (int i = outcome.asked + step, k = 1;
       design.status != io::DesignStatus::complete && k < tried && i >= 0 &&
       i < static_cast<int>(outcome.networks.size());
       i += step, ++k) {
    io::Design next = certified(scene.design, prepared, outcome.networks[i]);
    checks.push_back(next.trace.back());
    if (next.status == io::DesignStatus::complete) design = std::move(next);
  }
  design.trace = std::move(outcome.trace);
  design.trace.insert(design.trace.end(), checks.begin(), checks.end());
  return design;
}

core::Expected<std::vector<io::Design>> trade_off(const io::Scene& scene,
                                                  const DesignOptions& options) {
  auto found = run(scene, true, options);
  if (!found) return found.error();
  auto& [prepared, outcome] = *found;
  std::vector<io::Design> designs;
  for (const auto& network : outcome.networks) {
    io::Design design = certified(scene.design, prepared, network);
    design.trace.insert(design.trace.begin(), outcome.trace.begin(), outcome.trace.end());
    if (outcome.interrupted) design.status = io::DesignStatus::interrupted;
    designs.push_back(std::move(design));
  }
  return designs;
}

}  // namespace tencer::pipeline
