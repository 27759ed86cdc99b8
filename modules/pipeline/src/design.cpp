#include <algorithm>
#include <sstream>
#include <tencer/equilibrium/built.hpp>
#include <tencer/pipeline/design.hpp>
#include <tencer/pipeline/prepare.hpp>
#include <tencer/pipeline/simulate.hpp>
#include <tencer/sparsify/decimate.hpp>
#include <tencer/sparsify/dense.hpp>
#include <tencer/sparsify/slide.hpp>
#include <tencer/sparsify/sparsify.hpp>
#include <tencer/sparsify/thin.hpp>
#include <utility>

#include "record.hpp"

namespace tencer::pipeline {
namespace {

void say(const DesignOptions& options, core::Level level, const std::string& text) {
  if (options.log) options.log(level, text);
}

sparsify::SecondDerivatives second_derivatives(const std::string& name) {
  if (name == "exact") return sparsify::SecondDerivatives::exact;
  if (name == "gauss-newton") return sparsify::SecondDerivatives::gauss_newton;
  return sparsify::SecondDerivatives::none;
}

io::TraceRow trace_row(const sparsify::StageRow& row) {
  return {.stage = row.stage,
          .seconds = row.seconds,
          .cables = row.cables,
          .max_percent = row.max_percent,
          .rms_percent = row.rms_percent,
          .equilibrium_solves = row.solves,
          .newton_iterations = row.iterations,
          .note = row.note};
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

// The stages one after the other; ends early when one is interrupted, or leaves no cables: the rods
// then rest without.
class Route {
 public:
  Route(const DesignOptions& options, sparsify::StageResult start)
      : options_(options), result_(std::move(start)) {}

  template <class Stage>
  Route& then(Stage&& stage) {
    if (result_.interrupted || result_.network.structure.cables.empty()) return *this;
    sparsify::StageResult next = stage(result_.network);
    for (const auto& row : next.trace) {
      std::ostringstream line;
      line << row.stage << ": " << row.cables << " cables, max error " << row.max_percent << " %, "
           << row.seconds << " s" << (row.note.empty() ? "" : "; ") << row.note;
      say(options_, core::Level::info, line.str());
      trace_.push_back(trace_row(row));
    }
    result_ = std::move(next);
    return *this;
  }

  const sparsify::StageResult& result() const { return result_; }
  std::vector<io::TraceRow> take_trace() { return std::move(trace_); }

 private:
  const DesignOptions& options_;
  sparsify::StageResult result_;
  std::vector<io::TraceRow> trace_;
};

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

}  // namespace

core::Expected<io::Design> design(const io::Scene& scene, const DesignOptions& options) {
  const io::DesignSettings& settings = scene.design;
  const auto backend = optimize::find_backend(options.backends, settings.optimizer);
  if (!backend) return core::Error{scene.source, "design.optimizer: " + backend.error().message};
  const auto prepared = prepare(scene);
  if (!prepared) return prepared.error();
  for (const auto& sentence : prepared->left_out)
    say(options, core::Level::debug, "left out: " + sentence);
  const auto candidates =
      sparsify::candidates(prepared->structure, prepared->target.points, prepared->rules);
  if (!candidates)
    return core::Error{scene.source, why_no_candidates(scene, *prepared, candidates.error())};

  const sensitivity::Target& target = prepared->target;
  const sparsify::Control control{.stop = options.stop, .progress = options.progress};
  const sparsify::OuterOptions outer{.second_derivatives = second_derivatives(settings.hessian)};

  sparsify::StageResult start;
  start.network.structure = prepared->structure;
  start.network.structure.cables =
      sparsify::dense_springs(prepared->structure, target.points, *candidates);
  for (auto& cable : start.network.structure.cables)
    cable.stiffness *= settings.spring_stiffness / 100;
  start.network.state = prepared->start;

  Route route(options, std::move(start));
  route.then([&](const auto& network) { return sparsify::prune(network, target, control); })
      .then([&](const auto& network) {
        return sparsify::decimate(network, target, {.threshold = settings.greedy_threshold},
                                  control);
      })
      .then([&](const auto& network) {
        return sparsify::sparsify(network, target, *backend,
                                  {.max_percent = settings.max_error,
                                   .weights = settings.sparsity_weights,
                                   .longest = prepared->rules.longest,
                                   .outer = outer},
                                  control);
      })
      .then([&](const auto& network) {
        return sparsify::slide(network, target, prepared->rules, *backend, outer, control);
      })
      .then([&](const auto& network) {
        return sparsify::thin(network, target, prepared->rules, *backend,
                              {.max_percent = settings.max_error, .outer = outer}, control);
      });

  const sparsify::StageResult& result = route.result();
  io::Design design = file_of(*prepared, result.network);
  record(result.network.structure, result.network.state, sparsify::cable_tensions(result.network),
         target, prepared->units, design);
  design.trace = route.take_trace();
  if (result.interrupted) {
    design.status = io::DesignStatus::interrupted;
    return design;
  }
  design.trace.push_back(check_settling(design));
  const bool reached = design.error->max_percent <= settings.max_error &&
                       design.certificate->stable && *design.certificate->settles_from_target;
  design.status = reached ? io::DesignStatus::complete : io::DesignStatus::tolerance_not_reached;
  return design;
}

}  // namespace tencer::pipeline
