// tencer design INPUT: cables for a scene or a bare target curve.
#include <chrono>
#include <iomanip>
#include <iostream>
#include <memory>
#include <optional>
#include <sstream>
#include <tencer/core/words.hpp>
#include <tencer/io/file.hpp>
#include <tencer/model/units.hpp>
#include <tencer/pipeline/design.hpp>
#include <tencer/pipeline/feasible.hpp>
#include <tencer/pipeline/omissions.hpp>
#include <utility>
#include <vector>

#include "command.hpp"
#include "design_files.hpp"
#include "edit_input.hpp"
#include "interrupt.hpp"
#include "scene_input.hpp"

namespace tencer::app {
namespace {

constexpr const char* examples = R"(Examples:
  tencer design curve.obj                    defaults; the result is in curve-design/
  tencer design scene.toml -o result         rods, sections, anchors and rules from a scene file
  tencer design curve.obj --material ash     rods of ash, as thick as their bends allow
  tencer design curve.obj --max-error 0.5    the fewest cables that come as close as that
  tencer design curve.obj --cables 8         the closest design with at most 8 cables
  tencer design curve.obj --trade-off        how close with how many cables: all of them, in a table
  tencer design curve.obj --symmetry detect --objective rms
  tencer design curve.obj --method dense-springs --optimizer mma
  tencer design curve.obj --time 2           the best design that two seconds of search find
  tencer design curve.obj --from result/design.json --remove 1
                                             that design with a cable less, in no time
  tencer design scene.toml --explain         first what this scene needs, and what is left out

INPUT is a scene (.toml, see docs/scene.md), a curve (.obj, .csv, .json, .svg, .dxf and others, see
docs/curves.md) or a design whose target is designed for anew. The folder gets design.json, trace.csv
(error against run time), pose.obj, report.txt, view.html and picture.svg. With --trade-off these are
of the fewest cables within the max error (or of the closest design), and trade-off.csv and a folder
for each number of cables, such as cables-8/, come to them. Options override the scene; --max-error
and --trade-off also its number of cables. Ctrl-C ends early with the best design so far.)";

struct DesignRequest {
  SceneRequest scene;
  std::filesystem::path output;
  std::optional<model::Method> method;
  std::optional<model::Optimizer> optimizer;
  std::optional<model::SecondDerivatives> hessian;
  std::optional<model::Measure> objective;
  std::optional<model::SymmetryUse> symmetry;
  std::optional<int> threads;
  std::optional<double> time;
  std::optional<int> effort;
  EditRequest edit;
  std::optional<double> length_error_mm;
  std::optional<double> attachment_error_mm;
  std::optional<model::Allowance> max_deviation;
  bool trade_off = false;
  bool explain = false;
};

// One line a second at the most.
network::ProgressSink progress_lines(const core::Log& log) {
  using Clock = std::chrono::steady_clock;
  return [&log, last = Clock::now()](const network::Progress& progress) mutable {
    const auto now = Clock::now();
    if (now - last < std::chrono::seconds(1)) return;
    last = now;
    std::ostringstream line;
    line.precision(3);
    line << "  " << progress.stage << ": " << core::counted(progress.cables, "cable")
         << ", max error " << progress.max_percent << " %, " << progress.seconds << " s";
    log(core::Level::info, line.str());
  };
}

// The optimizer and the hessian asked for in place of the scene's.
std::optional<core::Error> apply_optimizer(const DesignRequest& request,
                                           model::DesignSettings& settings) {
  if (request.optimizer) {
    const auto known =
        optimize::find_backend(pipeline::backends(), model::name_of(*request.optimizer));
    if (!known) return core::Error{"--optimizer", known.error().message};
    settings.optimizer = *request.optimizer;
  }
  if (request.hessian) {
    settings.hessian = *request.hessian;
    for (const auto& problem : {model::hessian_problem(settings.optimizer, settings.hessian),
                                model::hessian_problem(settings.method, settings.hessian)})
      if (problem) return core::Error{"--hessian", *problem};
  } else if (request.optimizer && model::hessian_problem(settings.optimizer, settings.hessian)) {
    settings.hessian = model::DesignSettings{}.hessian;  // the scene's was for another optimizer
  }
  return std::nullopt;
}

// Options in place of the scene's keys.
std::optional<core::Error> apply(const DesignRequest& request, model::DesignSettings& settings) {
  if (request.trade_off && request.scene.cables)
    return core::Error{"--cables",
                       "--trade-off designs every number of cables; drop --cables for "
                       "all of them, or --trade-off for this one"};
  if (request.trade_off && (request.edit.add || request.edit.remove))
    return core::Error{request.edit.add ? "--add" : "--remove",
                       "asks for one number of cables, --trade-off for all; drop one of them"};
  if (request.method) settings.method = *request.method;
  if (const auto error = apply_optimizer(request, settings)) return error;
  if (request.trade_off) settings.cables.reset();  // else the scene's number would decide
  if (request.objective) settings.objective = *request.objective;
  if (request.symmetry) settings.symmetry = *request.symmetry;
  if (request.threads) settings.threads = *request.threads;
  if (request.time) settings.time = *request.time;
  if (request.effort) settings.effort = *request.effort;
  if (request.symmetry == model::SymmetryUse::detect &&
      settings.method != model::Method::force_balance)
    return core::Error{"--symmetry",
                       "networks of the method " + std::string(model::name_of(settings.method)) +
                           " do not keep symmetries; use none, or --method force-balance"};
  return std::nullopt;
}

// Why a design that ran to its end is not complete.
std::string shortfall(const model::Design& design) {
  std::string text = "not complete:";
  for (const std::string& reason : model::shortfalls(design)) text += ' ' + reason + ';';
  return text + " design.json says so\n";
}

// Designs, writes and returns the one asked for.
core::Expected<model::Design> make_design(const std::filesystem::path& folder,
                                          const model::Scene& scene, bool all_numbers,
                                          const pipeline::RunOptions& options) {
  if (!all_numbers) {
    auto design = pipeline::design(scene, options);
    if (!design) return design.error();
    if (const auto error = write_design_files(folder, *design)) return *error;
    return std::move(*design);
  }
  const auto designs = pipeline::trade_off(scene, options);
  if (!designs) return designs.error();
  const model::Design& best = pipeline::best_for(pipeline::goal_of(scene.design), *designs);
  if (const auto error = write_trade_off(folder, *designs, best)) return *error;
  std::cout << trade_off_table(*designs);
  return best;
}

// What no cables can hold: the proof in place of a design.
core::Expected<ExitCode> refuse(const std::filesystem::path& folder,
                                const model::Feasibility& found) {
  if (const auto error = write_feasibility_files(folder, found)) return *error;
  std::cout << model::report(found) << "see " << (folder / "picture.svg").string() << '\n';
  return ExitCode::tolerance_not_reached;
}

// What the scene needs and what is left out, a line each.
std::string explanation(const std::vector<pipeline::Feature>& features) {
  std::ostringstream text;
  for (const bool used : {false, true}) {
    text << (used ? "needed:\n" : "left out:\n");
    for (const auto& feature : features)
      if (feature.used == used)
        text << "  " << std::left << std::setw(19) << feature.name << ' ' << feature.why << '\n';
  }
  return text.str();
}

void apply_errors(const DesignRequest& request, model::Scene& scene) {
  const double millimetre = 1e-3 / model::metres(scene.length_unit);
  if (request.length_error_mm) scene.build.length_error = *request.length_error_mm * millimetre;
  if (request.attachment_error_mm)
    scene.build.attachment_error = *request.attachment_error_mm * millimetre;
  if (request.max_deviation) scene.build.max_deviation = request.max_deviation;
}

core::Expected<ExitCode> run_design(const DesignRequest& request, const core::Log& log) {
  auto scene = requested_scene(request.scene);
  if (!scene) return scene.error();
  if (const auto error = apply(request, scene->design)) return *error;
  apply_errors(request, *scene);
  if (const auto error = apply(request.edit, request.scene.cables.has_value(), *scene))
    return *error;
  const std::filesystem::path folder =
      request.output.empty()
          ? std::filesystem::path(
                (request.scene.input == "-" ? "stdin" : request.scene.input.stem().string()) +
                "-design")
          : request.output;
  if (const auto error = io::folder_problem(folder)) return *error;
  if (request.explain) {
    const auto prepared = pipeline::prepare(*scene);
    if (!prepared) return prepared.error();
    std::cout << explanation(pipeline::features_of(*scene, *prepared)) << std::flush;
  }

  const Interrupt interrupt;
  const auto found = pipeline::feasible(
      *scene, {.mends = pipeline::TryMends::if_it_cannot, .stop = interrupt.token()});
  if (!found) return found.error();
  if (found->verdict == model::Verdict::cannot) return refuse(folder, *found);
  const auto design = make_design(folder, *scene, request.trade_off,
                                  {.stop = interrupt.token(),
                                   .progress = progress_lines(log),
                                   .log = log,
                                   .feasible_first = false});
  if (!design) return design.error();

  std::cout << model::summary(*design);
  if (design->status == model::DesignStatus::interrupted)
    std::cout << "interrupted: this is the best design so far\n";
  else if (design->status == model::DesignStatus::tolerance_not_reached)
    std::cout << shortfall(*design)
              << (found->verdict == model::Verdict::unclear
                      ? "whether cables can hold this so closely was " + model::summary(*found) +
                            '\n'
                      : "");
  else if (design->structure.cables.empty())
    std::cout << "the rods rest in this shape by themselves\n";
  std::cout << "see " << (folder / "view.html").string() << '\n';
  return design->status == model::DesignStatus::complete ? ExitCode::ok
                                                         : ExitCode::tolerance_not_reached;
}

}  // namespace

void add_design(CLI::App& app, Command& chosen) {
  CLI::App* command =
      app.add_subcommand("design", "Design cables that hold rods in a target shape");
  command->footer(examples);
  const auto request = std::make_shared<DesignRequest>();
  command->add_option("-o,--output", request->output, "Folder for the result [INPUT-design]");
  add_scene(*command, request->scene,
            "The closest design with at most so many, however far from the target");
  command->add_flag("--trade-off", request->trade_off,
                    "Design every number of cables, and list how close each comes");
  const model::DesignSettings standard;
  add_choice(*command, "--objective", request->objective,
             "Which of the distances to the target is made small", standard.objective);
  add_choice(*command, "--symmetry", request->symmetry,
             "Whether the cables keep the target's symmetries, or you are told of them",
             standard.symmetry, {model::SymmetryUse::given});
  add_choice(*command, "--method", request->method, "The way to a network", standard.method);
  add_choice(*command, "--optimizer", request->optimizer,
             "Who makes the last fit, and in dense-springs all of them", standard.optimizer);
  add_choice(*command, "--hessian", request->hessian,
             "What gauss-newton or ipopt is told of curvature", standard.hessian);
  command
      ->add_option("--threads", request->threads,
                   "How many threads share the work; the design is the same [the scene's, else as "
                   "many as the machine has]")
      ->check(positive_integer());
  command
      ->add_option("--time", request->time,
                   "Seconds after which the search ends with the best so far; the last checks "
                   "follow [the scene's, else until it stops to pay]")
      ->check(positive_number());
  command
      ->add_option("--effort", request->effort,
                   "Of the search: 1 quick, 2, 3 thorough [the scene's, else 2]")
      ->check(CLI::Range(1, 3));
  add_edit(*command, request->edit);
  command
      ->add_option("--length-error", request->length_error_mm,
                   "To how many mm cables are cut: the design forgives it [the scene's, else 1]")
      ->check(not_negative_number());
  command
      ->add_option("--attachment-error", request->attachment_error_mm,
                   "To how many mm they are tied along the rods, likewise [the scene's, else 2]")
      ->check(not_negative_number());
  command
      ->add_option_function<std::string>(
          "--max-deviation",
          [request](const std::string& text) {
            request->max_deviation = model::read_allowance(text);
          },
          "What these errors may move of 95 in 100 built so: 5mm, or 1% of the size [the scene's, "
          "else the max error]")
      ->check(allowance());
  command->add_flag("--explain", request->explain,
                    "Say first what this scene needs, and what is left out and why");
  command->callback([&chosen, request] {
    chosen = [request](const core::Log& log) { return run_design(*request, log); };
  });
}

}  // namespace tencer::app
