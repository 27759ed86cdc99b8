// tencer design INPUT: cables for a scene or a bare target curve.
#include <iostream>
#include <tencer/io/summary.hpp>
#include <tencer/pipeline/design.hpp>
#include <tencer/pipeline/feasible.hpp>

#include "command.hpp"
#include "design/design_progress.hpp"
#include "design/design_request.hpp"
#include "design/design_words.hpp"
#include "design_files.hpp"
#include "interrupt.hpp"

namespace tencer::app {
namespace {

constexpr const char* design_examples = R"(Examples:
  tencer design curve.obj                    defaults; the result is in curve-design/
  tencer design scene.toml -o result         rods, sections, anchors and rules from a scene file
  tencer design scene.toml --dry-run         what this scene needs, and what is left out
  tencer design curve.obj --material ash     rods of ash, as thick as their bends allow
  tencer design curve.obj --max-error 0.5    the fewest cables that come as close as that
  tencer design curve.obj --cables 8         the closest design with at most 8 cables
  tencer design curve.obj --trade-off        how close with how many cables: all of them, in a table
  tencer design curve.obj --view 0,0,1       only what is seen along z has to be right
  tencer design curve.obj --symmetry detect --objective rms
  tencer design curve.obj --method dense-springs --optimizer mma
  tencer design curve.obj --time 2           the best design that two seconds of search find
  tencer design curve.obj --from result/design.json --remove 1
                                             that design with a cable less, in no time
  tencer design curve.obj --picture curve.pdf
                                             also a picture of it, for print
  tencer design curve.obj --json | jq .error for programs

INPUT is a scene (.toml, see docs/scene.md), a curve (.obj, .csv, .json, .svg, .dxf and others, see
docs/curves.md) or a design whose target is designed for anew. The folder gets design.json, trace.csv
(error against run time), pose.obj, report.txt, view.html and picture.svg. With --trade-off these are
of the fewest cables within the max error (or of the closest design), and trade-off.csv and a folder
for each number of cables, such as cables-8/, come to them. Options override the scene; --max-error
and --trade-off also its number of cables. Ctrl-C ends early with the best design so far.)";

struct Found {
  model::Design asked{};
  std::vector<model::Design> trade_off{};  // every number of cables, when it was asked for
};

// Designs and writes.
core::Expected<Found> make_design(const std::filesystem::path& folder, const model::Scene& scene,
                                  bool all_numbers, const pipeline::RunOptions& options) {
  if (!all_numbers) {
    auto design = pipeline::design(scene, options);
    if (!design) return design.error();
    if (const auto error = write_design_files(folder, *design)) return *error;
    return Found{std::move(*design)};
  }
  auto designs = pipeline::trade_off(scene, options);
  if (!designs) return designs.error();
  const model::Design& best = pipeline::best_for(pipeline::goal_of(scene.design), *designs);
  if (const auto error = write_trade_off(folder, *designs, best)) return *error;
  return Found{best, std::move(*designs)};
}

// What no cables can hold: the proof in place of a design, unless an earlier one is there.
core::Expected<ExitCode> refuse(const std::filesystem::path& folder,
                                const model::Feasibility& found, bool json,
                                const Console& console) {
  const bool kept = holds_design(folder);
  if (!kept)
    if (const auto error = write_feasibility_files(folder, found)) return *error;
  if (json)
    std::cout << io::summary_text(found);
  else
    console.say(model::report(found) +
                (kept ? "the design that is in " + folder.string() + " stays as it was\n"
                      : "see " + (folder / "picture.svg").string() + '\n'));
  return ExitCode::tolerance_not_reached;
}

core::Expected<ExitCode> run_design(const DesignRequest& request, const Console& console) {
  Activity activity(console, "reading");
  auto scene = requested_scene(request);
  if (!scene) return scene.error();
  const std::filesystem::path folder = request.folder();
  if (const auto error = result_problem(folder, scene->name, request.force)) return *error;
  if (const auto error = pipeline::scene_problem(*scene)) return *error;
  if (const auto error = pictures_problem(request)) return *error;
  const Interrupt interrupt;
  introduce(*scene, console);
  if (request.dry_run) return dry_run(*scene, folder, console);

  activity.now("looking whether cables can hold this");
  const auto feasible = pipeline::feasible(
      *scene,
      {.mends = pipeline::TryMends::if_it_cannot, .at_least = false, .stop = interrupt.token()});
  if (!feasible) return feasible.error();
  if (feasible->verdict == model::Verdict::cannot) {
    activity.end();
    return refuse(folder, *feasible, request.json, console);
  }
  DesignProgress progress(activity, *scene, request.trade_off);
  const auto found =
      make_design(folder, *scene, request.trade_off,
                  {.stop = interrupt.token(),
                   .progress = [&](const network::Progress& at) { progress.tell(at); },
                   .log = console.log(),
                   .feasible_first = false});
  if (!found) return found.error();
  if (const auto error = write_pictures(request.pictures, found->asked)) return *error;

  activity.end();
  if (const auto old = old_sheet(folder)) console.log()(core::Level::warning, *old);
  if (request.json)
    std::cout << io::summary_text(found->asked,
                                  {{"folder", folder.string()}, {"seconds", activity.seconds()}},
                                  found->trade_off);
  else
    console.say(trade_off_table(found->trade_off) + result_in_words(found->asked, *feasible) +
                seen_in(folder, activity.seconds()));
  return found->asked.complete() ? ExitCode::ok : ExitCode::tolerance_not_reached;
}

}  // namespace

void add_design(CLI::App& app, Command& chosen) {
  CLI::App* command =
      app.add_subcommand("design", "Design cables that hold rods in a target shape");
  command->footer(design_examples);
  const auto request = std::make_shared<DesignRequest>();
  add_design_options(*command, request);
  command->callback([&chosen, request] {
    chosen = [request](const Console& console) { return run_design(*request, console); };
  });
}

}  // namespace tencer::app
