// tencer simulate DESIGN: where a designed structure comes to rest.
#include <algorithm>
#include <iomanip>
#include <iostream>
#include <memory>
#include <sstream>
#include <tencer/core/words.hpp>
#include <tencer/io/summary.hpp>
#include <tencer/model/target.hpp>
#include <tencer/model/units.hpp>
#include <tencer/pipeline/simulate.hpp>

#include "command.hpp"
#include "design_files.hpp"
#include "interrupt.hpp"
#include "terminal/activity.hpp"

namespace tencer::app {
namespace {

constexpr const char* simulate_examples = R"(Examples:
  tencer simulate knot/design.json                            from the pose, inextensible cables
  tencer simulate knot/design.json --from target --cables springs -o settled
  tencer simulate knot/design.json -o fine --refine           with rods of four times the vertices

Inextensible cables have the design's lengths and go slack rather than push. Springs use each cable's
stiffness and rest_length. Without -o nothing is written. --refine divides every edge and tells how
far the vertices of the file move: what its number of vertices does to the pose. From the pose,
inextensible cables go slowly from the lengths that they have there to those of the design, so that
a jump is the structure's own. A design that moves by more than 1 % of the target's size does not
stay in its pose: a warning says so, and the exit code is 3.)";

struct SimulateRequest {
  std::filesystem::path input;
  std::filesystem::path output;
  std::string from = "pose";
  std::string cables = "inextensible";
  int refine = pipeline::SimulateOptions{}.refine;
  bool json = false;
  bool force = false;
  double tolerance = equilibrium::SolveOptions{}.tolerance;
};

// "1.2 mm (0.3 % of the target's size)"
std::string motion(const pipeline::Simulation& result) {
  std::ostringstream text;
  text << std::setprecision(3);
  const model::Design& design = result.design;
  const std::string& unit = design.length_unit;
  if (std::ranges::count(model::length_units(), unit) == 0) {
    text << result.moved_percent << " % of the target's size";
  } else {
    const double mm = 1000 * model::metres(unit) * model::diagonal({.points = design.target});
    text << result.moved_percent / 100 * mm << " mm (" << result.moved_percent
         << " % of the target's size)";
  }
  return text.str();
}

std::string warning_of_motion(const std::filesystem::path& input,
                              const pipeline::Simulation& result) {
  std::ostringstream text;
  text << input.string() << ": the design does not stay in its pose: it "
       << (result.fold_at ? "jumps" : "moves") << " by " << motion(result);
  if (result.fold_at)
    text << ", after " << 100 * *result.fold_at
         << " % of the way from the lengths and forces in the pose to those of the design";
  return text.str();
}

std::string in_words(const pipeline::Simulation& result, int refine) {
  std::ostringstream text;
  text << describe(result.reason) << ": " << core::counted(result.iterations, "iteration") << ", "
       << core::counted(result.factorisations, "factorisation") << ", "
       << core::counted(result.unknowns, "unknown") << ", " << result.seconds * 1e3
       << " ms, residual " << result.residual << '\n'
       << "largest motion from the file's pose " << motion(result);
  if (refine > 1) text << ", with " << refine << " edges for each";
  text << '\n' << model::summary(result.design);
  return text.str();
}

std::string in_json(const pipeline::Simulation& result) {
  return io::summary_text(result.design, {{"reason", describe(result.reason)},
                                          {"stays", result.stays()},
                                          {"moved_percent", result.moved_percent},
                                          {"iterations", static_cast<double>(result.iterations)},
                                          {"residual", result.residual},
                                          {"seconds", result.seconds}});
}

core::Expected<ExitCode> run_simulate(const SimulateRequest& request, const Console& console) {
  const auto design = io::read_design(request.input);
  if (!design) return design.error();
  if (!request.output.empty())
    if (const auto error = result_problem(request.output, design->name, request.force))
      return *error;
  const Interrupt interrupt;
  Activity activity(console, "simulating");
  const auto result = pipeline::simulate(
      *design, {.start = request.from == "target" ? pipeline::Start::target : pipeline::Start::pose,
                .cables = request.cables == "springs" ? pipeline::Cables::springs
                                                      : pipeline::Cables::inextensible,
                .refine = request.refine,
                .solve = {.tolerance = request.tolerance, .stop = interrupt.token()}});
  if (!result) return core::Error{request.input.string(), result.error().text()};
  if (!request.output.empty())
    if (const auto error = write_design_files(request.output, result->design)) return *error;
  activity.end();
  if (request.json)
    std::cout << in_json(*result);
  else
    console.say(in_words(*result, request.refine));
  std::cout.flush();
  if (result->usable() && !result->stays())
    console.log()(core::Level::warning, warning_of_motion(request.input, *result));
  return result->stays() ? ExitCode::ok : ExitCode::tolerance_not_reached;
}

}  // namespace

void add_simulate(CLI::App& app, Command& chosen) {
  CLI::App* command = app.add_subcommand("simulate", "Find where a design comes to rest");
  command->footer(simulate_examples);
  const auto request = std::make_shared<SimulateRequest>();
  command->add_option("DESIGN", request->input, "Design (design.json), or a published model")
      ->required();
  command->add_option("--from", request->from, "Where the rods start")
      ->check(one_of({"target", "pose"}))
      ->capture_default_str();
  command->add_option("--cables", request->cables, "What the cables are")
      ->check(one_of({"springs", "inextensible"}))
      ->capture_default_str();
  command
      ->add_option("--refine", request->refine,
                   "Edges for each edge: 1 without this option, 4 when no number follows")
      ->check(CLI::Range(1, 1000))
      ->expected(0, 1)
      ->default_str("4");
  command->add_option("--tolerance", request->tolerance, "Of forces, relative to the rods' own")
      ->check(positive_number())
      ->capture_default_str();
  command->add_flag("--json", request->json, "Write JSON instead of words");
  command->add_option("-o,--output", request->output, "Folder for the design at rest");
  add_force(*command, request->force);
  command->callback([&chosen, request] {
    chosen = [request](const Console& console) { return run_simulate(*request, console); };
  });
}

}  // namespace tencer::app
