#include <algorithm>
#include <tencer/equilibrium/built.hpp>
#include <tencer/pipeline/design.hpp>
#include <tencer/pipeline/prepare.hpp>
#include <tencer/pipeline/simulate.hpp>
#include <tencer/pipeline/symmetry.hpp>
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

core::Expected<CandidateSets> candidate_sets(const io::Scene& scene, const Prepared& prepared) {
  const auto& points = prepared.target.points;
  auto with_pins = sparsify::candidates(prepared.structure, points, prepared.rules);
  if (!with_pins)
    return core::Error{scene.source, why_no_candidates(scene, prepared, with_pins.error())};
  if (!scene.design.hand_over) return CandidateSets{std::move(*with_pins), {}};
  equilibrium::Structure released = prepared.structure;
  released.pins.clear();
  auto without_pins = sparsify::candidates(released, points, prepared.rules);
  if (!without_pins) return core::Error{scene.source, without_pins.error().message};
  return CandidateSets{std::move(*with_pins), std::move(*without_pins)};
}

// The design file with its cables; what depends on the equilibrium is missing.
io::Design file_of(const Prepared& prepared, const sparsify::Network& network) {
  const Units& units = prepared.units;
  io::Design design = prepared.file;
  if (network.structure.pins.empty()) design.pinned.clear();  // they may have been handed over
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

// Whether it has few enough cables, or is close enough.
bool answers(const io::DesignSettings& settings, const io::Design& design) {
  return settings.cables ? static_cast<int>(design.cables.size()) <= *settings.cables
                         : design.error->max_percent <= settings.max_error;
}

// The design of a network: complete unless it falls short of what the settings ask for.
io::Design certified(const io::DesignSettings& settings, const Prepared& prepared,
                     const sparsify::Network& network) {
  io::Design design = file_of(prepared, network);
  record(network.structure, network.state, sparsify::cable_tensions(network), prepared.target,
         prepared.units, design);
  const io::TraceRow row = check_settling(design);
  design.trace.push_back(row);
  design.status = answers(settings, design) && design.certificate->stable &&
                          *design.certificate->settles_from_target
                      ? io::DesignStatus::complete
                      : io::DesignStatus::tolerance_not_reached;
  return design;
}

void offer_symmetry(const Prepared& prepared, const DesignOptions& options) {
  if (!options.log) return;
  const std::string found = symmetry_in_words(prepared);
  if (found.empty()) return;
  options.log(core::Level::info, "the target has " + found +
                                     ": with symmetry = \"detect\" in [design], or --symmetry "
                                     "detect, the cables have it too");
}

// The scene checked and ready, with all that its cables can be chosen from.
struct Job {
  const io::Scene& scene;
  Prepared prepared{};
  CandidateSets candidates{};
  optimize::Backend backend{};
};

core::Expected<Job> begin(const io::Scene& scene, const DesignOptions& options) {
  const io::DesignSettings& settings = scene.design;
  auto backend = optimize::find_backend(options.backends, settings.optimizer);
  if (!backend) return core::Error{scene.source, "design.optimizer: " + backend.error().message};
  auto prepared = prepare(scene);
  if (!prepared) return prepared.error();
  for (const Part& part : prepared->parts)
    if (!part.used) say(options, core::Level::debug, "no " + part.name + ": " + part.why);
  auto candidates = candidate_sets(scene, *prepared);
  if (!candidates) return candidates.error();
  if (settings.symmetry == "offer" && settings.method == "force-balance")
    offer_symmetry(*prepared, options);
  return Job{scene, std::move(*prepared), std::move(*candidates), std::move(*backend)};
}

Outcome run(const Job& job, bool every_number, const DesignOptions& options) {
  return run_route(job.scene.design, job.prepared, job.candidates, job.backend, every_number,
                   options);
}

// The networks certified one after the other, from the one asked for on, until one is complete: it
// is better than one that does not stand or settles elsewhere, unless it is much further from the
// target. When none is, the one asked for. Its row of the trace comes last.
io::Design first_complete(const Job& job, const Outcome& outcome, int tries) {
  const io::DesignSettings& settings = job.scene.design;
  const int step = settings.cables ? -1 : 1;
  io::Design best;
  std::vector<io::TraceRow> checks;
  int i = outcome.asked;
  for (int k = 0; k < tries && i >= 0 && i < static_cast<int>(outcome.networks.size());
       i += step, ++k) {
    io::Design design = certified(settings, job.prepared, outcome.networks[i]);
    constexpr double worth = 2;  // times the distance
    const bool complete = design.status == io::DesignStatus::complete &&
                          (k == 0 || !settings.cables ||
                           design.error->max_percent <= worth * best.error->max_percent);
    if (complete || k == 0) std::swap(best, design);
    if (!design.trace.empty()) checks.push_back(design.trace.back());
    if (complete) break;
  }
  checks.push_back(best.trace.back());
  best.trace = outcome.trace;
  best.trace.insert(best.trace.end(), checks.begin(), checks.end());
  return best;
}

}  // namespace

core::Expected<io::Design> design(const io::Scene& scene, const DesignOptions& options) {
  const auto job = begin(scene, options);
  if (!job) return job.error();
  const Outcome outcome = run(*job, false, options);
  if (outcome.interrupted) {
    const auto& asked = outcome.networks[outcome.asked];
    io::Design design = file_of(job->prepared, asked);
    record(asked.structure, asked.state, sparsify::cable_tensions(asked), job->prepared.target,
           job->prepared.units, design);
    design.trace = outcome.trace;
    design.status = io::DesignStatus::interrupted;
    return design;
  }
  constexpr int tries = 6;
  return first_complete(*job, outcome, tries);
}

core::Expected<std::vector<io::Design>> trade_off(const io::Scene& scene,
                                                  const DesignOptions& options) {
  const auto job = begin(scene, options);
  if (!job) return job.error();
  const Outcome outcome = run(*job, true, options);
  std::vector<io::Design> designs;
  for (const auto& network : outcome.networks) {
    io::Design design = certified(scene.design, job->prepared, network);
    design.trace.insert(design.trace.begin(), outcome.trace.begin(), outcome.trace.end());
    if (outcome.interrupted) design.status = io::DesignStatus::interrupted;
    designs.push_back(std::move(design));
  }
  return designs;
}

}  // namespace tencer::pipeline
