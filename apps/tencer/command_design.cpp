// tencer design INPUT: cables for a scene or a bare target curve.
#include <chrono>
#include <iomanip>
#include <iostream>
#include <memory>
#include <optional>
#include <sstream>
#include <tencer/equilibrium/rigid_modes.hpp>
#include <tencer/io/file.hpp>
#include <tencer/pipeline/convert.hpp>
#include <tencer/pipeline/design.hpp>
#include <tencer/pipeline/prepare.hpp>
#include <tencer/pipeline/resolution.hpp>
#include <utility>
#include <vector>

#include "command.hpp"
#include "design_files.hpp"
#include "interrupt.hpp"
#include "scene_input.hpp"

namespace tencer::app {
namespace {

constexpr const char* examples = R"(Examples:
  tencer design curve.obj                    defaults; the result is in curve-design/
  tencer design scene.toml -o result         rods, sections, anchors and rules from a scene file
  tencer design curve.obj --max-error 0.5    the fewest cables that come as close as that
  tencer design curve.obj --cables 8         the closest design with at most 8 cables
  tencer design curve.obj --trade-off        how close with how many cables: all of them, in a table
  tencer design curve.obj --symmetry detect --objective rms
  tencer design curve.obj --method dense-springs --optimizer mma
  tencer design scene.toml --explain         first what this scene needs, and what is left out

INPUT is a scene (.toml, see docs/scene.md) or a curve (.obj, .csv, .xyz, .txt, .json). The folder
gets design.json, trace.csv (error against run time), pose.obj, view.html and picture.svg. With
--trade-off these are of the fewest cables within the max error (or of the closest design), and
trade-off.csv and a folder for each number of cables, such as cables-8/, come to them. Options go
before what the scene says; --max-error and --trade-off also before its number of cables. Ctrl-C ends
early with the best design so far.)";

struct DesignRequest {
  std::filesystem::path input;
  std::filesystem::path output;
  std::optional<std::string> method;
  std::optional<std::string> optimizer;
  std::optional<std::string> hessian;
  std::optional<double> max_error;
  std::optional<int> cables;
  std::optional<std::string> objective;
  std::optional<std::string> symmetry;
  std::optional<int> threads;
  double resolution = 1.0;
  bool trade_off = false;
  bool explain = false;
};

// One line a second at the most.
std::function<void(const sparsify::Progress&)> progress_lines(const core::Log& log) {
  auto last =
      std::make_shared<std::chrono::steady_clock::time_point>(std::chrono::steady_clock::now());
  return [&log, last](const sparsify::Progress& progress) {
    const auto now = std::chrono::steady_clock::now();
    if (now - *last < std::chrono::seconds(1)) return;
    *last = now;
    std::ostringstream line;
    line.precision(3);
    line << "  " << progress.stage << ": " << progress.cables << " cables, max error "
         << progress.max_percent << " %, " << progress.seconds << " s";
    log(core::Level::info, line.str());
  };
}

// Options in place of the scene's keys.
std::optional<core::Error> apply(const DesignRequest& request, io::DesignSettings& settings) {
  if (request.trade_off && request.cables)
    return core::Error{"--cables",
                       "--trade-off designs every number of cables; drop --cables for "
                       "all of them, or --trade-off for this one"};
  if (request.optimizer) {
    const auto known = optimize::find_backend(pipeline::backends(), *request.optimizer);
    if (!known) return core::Error{"--optimizer", known.error().message};
    settings.optimizer = *request.optimizer;
  }
  if (request.hessian) {
    settings.hessian = *request.hessian;
    if (const auto problem = io::hessian_problem(settings))
      return core::Error{"--hessian", *problem};
  } else if (request.optimizer && io::hessian_problem(settings)) {
    settings.hessian = io::DesignSettings{}.hessian;  // the scene's was for another optimizer
  }
  if (request.method) settings.method = *request.method;
  if ((request.optimizer || request.hessian) && settings.method != "dense-springs")
    return core::Error{request.optimizer ? "--optimizer" : "--hessian",
                       "is of no use to the method " + settings.method +
                           "; drop it, or add --method dense-springs"};
  // Else the scene's number of cables would decide.
  if (request.max_error || request.trade_off) settings.cables.reset();
  if (request.max_error) settings.max_error = *request.max_error;
  if (request.cables) settings.cables = *request.cables;
  if (request.objective) settings.objective = *request.objective;
  if (request.symmetry) settings.symmetry = *request.symmetry;
  if (request.threads) settings.threads = *request.threads;
  if (request.symmetry == "detect" && settings.method != "force-balance")
    return core::Error{"--symmetry", "networks of the method " + settings.method +
                                         " do not keep symmetries; use none, or --method "
                                         "force-balance"};
  return std::nullopt;
}

// Of rods, free to move against each other.
int free_groups(const io::Design& design) {
  const pipeline::Units units = pipeline::units_of(design);
  const auto structure = pipeline::structure_of(design, pipeline::Cables::inextensible, units);
  return equilibrium::free_groups(equilibrium::rigid_modes(
      equilibrium::System(structure), pipeline::pose_state(design, structure, units)));
}

// Why a design that ran to its end is not complete.
std::string shortfall(const io::Design& design, const io::DesignSettings& settings) {
  std::ostringstream text;
  text << "not complete:";
  if (settings.cables && static_cast<int>(design.cables.size()) > *settings.cables)
    text << " it has more cables than the " << *settings.cables << " asked for;";
  if (!settings.cables && design.error->max_percent > settings.max_error)
    text << " the max error is above the " << settings.max_error << " % asked for;";
  if (!design.certificate->stable) text << " it does not stand;";
  if (const int groups = free_groups(design); groups > 1)
    text << " nothing ties its " << groups << " groups of rods to each other;";
  if (!design.certificate->settles_from_target.value_or(true))
    text << " let go at the target it comes to rest elsewhere;";
  text << " design.json says so\n";
  return text.str();
}

// The design that answers what the settings ask for, out of those for all numbers of cables.
const io::Design& asked(const std::vector<io::Design>& designs,
                        const io::DesignSettings& settings) {
  const auto close = [&](const io::Design& design) {
    return design.error->max_percent <= settings.max_error;
  };
  // Not by their status, which says of all of them when the run was interrupted.
  for (const auto& design : designs)
    if (close(design) && design.certificate->stable && *design.certificate->settles_from_target)
      return design;
  for (const auto& design : designs)
    if (close(design)) return design;
  return designs.back();
}

// Designs, writes and returns the one asked for.
core::Expected<io::Design> make_design(const std::filesystem::path& folder, const io::Scene& scene,
                                       bool all_numbers, const pipeline::DesignOptions& options) {
  if (!all_numbers) {
    auto design = pipeline::design(scene, options);
    if (!design) return design.error();
    if (const auto error = write_design_files(folder, *design)) return *error;
    return std::move(*design);
  }
  const auto designs = pipeline::trade_off(scene, options);
  if (!designs) return designs.error();
  const io::Design& best = asked(*designs, scene.design);
  if (const auto error = write_trade_off(folder, *designs, best)) return *error;
  std::cout << trade_off_table(*designs);
  return best;
}

// What the scene needs and what is left out, a line each.
std::string explanation(const std::vector<pipeline::Part>& parts) {
  std::ostringstream text;
  for (const bool used : {false, true}) {
    text << (used ? "needed:\n" : "left out:\n");
    for (const auto& part : parts)
      if (part.used == used)
        text << "  " << std::left << std::setw(19) << part.name << ' ' << part.why << '\n';
  }
  return text.str();
}

core::Expected<ExitCode> run_design(const DesignRequest& request, const core::Log& log) {
  auto scene = read_scene_or_curve(request.input);
  if (!scene) return scene.error();
  if (const auto error = apply(request, scene->design)) return *error;
  *scene = pipeline::at_resolution(*scene, request.resolution);
  const std::filesystem::path folder =
      request.output.empty() ? std::filesystem::path(request.input.stem().string() + "-design")
                             : request.output;
  if (const auto error = io::folder_problem(folder)) return *error;
  if (request.explain) {
    const auto prepared = pipeline::prepare(*scene);
    if (!prepared) return prepared.error();
    std::cout << explanation(prepared->parts) << std::flush;
  }

  const Interrupt interrupt;
  const auto design =
      make_design(folder, *scene, request.trade_off,
                  {.stop = interrupt.token(), .progress = progress_lines(log), .log = log});
  if (!design) return design.error();

  std::cout << summary(*design);
  if (design->status == io::DesignStatus::interrupted)
    std::cout << "interrupted: this is the best design so far\n";
  else if (design->status == io::DesignStatus::tolerance_not_reached)
    std::cout << shortfall(*design, scene->design);
  else if (design->cables.empty())
    std::cout << "the rods rest in this shape by themselves\n";
  std::cout << "see " << (folder / "view.html").string() << '\n';
  return design->status == io::DesignStatus::complete ? ExitCode::ok
                                                      : ExitCode::tolerance_not_reached;
}

std::string backend_names() {
  std::string names;
  for (const auto& backend : pipeline::backends())
    names += (names.empty() ? "" : ", ") + backend.name;
  return names;
}

}  // namespace

void add_design(CLI::App& app, Command& chosen) {
  CLI::App* command =
      app.add_subcommand("design", "Design cables that hold rods in a target shape");
  command->footer(examples);
  const auto request = std::make_shared<DesignRequest>();
  command->add_option("INPUT", request->input, "Scene (.toml) or target curve")->required();
  command->add_option("-o,--output", request->output, "Folder for the result [INPUT-design]");
  command
      ->add_option("--max-error", request->max_error,
                   "Largest distance to the target, % of its bounding-box diagonal [1]")
      ->check(positive_number());
  command
      ->add_option("--cables", request->cables,
                   "The closest design with at most so many, however far from the target")
      ->check(positive_integer());
  command->add_flag("--trade-off", request->trade_off,
                    "Design every number of cables, and list how close each comes");
  command
      ->add_option("--objective", request->objective,
                   "Which of the distances to the target is made small [the scene's, else " +
                       io::DesignSettings{}.objective + "]")
      ->check(CLI::IsMember({"max", "rms"}));
  command
      ->add_option("--symmetry", request->symmetry,
                   "Whether the cables keep the target's symmetries, or you are told of them [the "
                   "scene's, else " +
                       io::DesignSettings{}.symmetry + "]")
      ->check(CLI::IsMember({"none", "offer", "detect"}));
  command
      ->add_option("--method", request->method,
                   "The way to a network [the scene's, else " + io::DesignSettings{}.method + "]")
      ->check(CLI::IsMember({"force-balance", "dense-springs"}));
  command->add_option("--optimizer", request->optimizer,
                      "Outer optimizer of dense-springs: " + backend_names() +
                          " [the scene's, else " + io::DesignSettings{}.optimizer + "]");
  command
      ->add_option("--hessian", request->hessian,
                   "What gauss-newton or ipopt is told of curvature [the scene's, else " +
                       io::DesignSettings{}.hessian + "]")
      ->check(CLI::IsMember({"limited-memory", "gauss-newton", "exact"}));
  command
      ->add_option("--threads", request->threads,
                   "How many threads share the work; the design is the same [the scene's, else as "
                   "many as the machine has]")
      ->check(positive_integer());
  command
      ->add_option("--resolution", request->resolution,
                   "Vertices of every rod, times what the scene has")
      ->check(positive_number())
      ->check(CLI::Range(0.01, 100.0))
      ->capture_default_str();
  command->add_flag("--explain", request->explain,
                    "Say first what this scene needs, and what is left out and why");
  command->callback([&chosen, request] {
    chosen = [request](const core::Log& log) { return run_design(*request, log); };
  });
}

}  // namespace tencer::app
