// tencer feasible INPUT: whether the cables that are allowed can hold a shape at all.
#include <iostream>
#include <memory>
#include <tencer/io/file.hpp>
#include <tencer/io/summary.hpp>
#include <tencer/pipeline/design.hpp>
#include <tencer/pipeline/feasible.hpp>

#include "command.hpp"
#include "design/design_words.hpp"
#include "design_files.hpp"
#include "interrupt.hpp"
#include "scene_input.hpp"
#include "terminal/activity.hpp"

namespace tencer::app {
namespace {

constexpr const char* feasible_examples = R"(Examples:
  tencer feasible curve.obj                  can a rod be held in this shape within 1 % of its size?
  tencer feasible scene.toml --max-error 0.5
  tencer feasible curve.obj -o result        also the motion that proves that it cannot, drawn

All cables that are allowed are tied at once, and the rods are let go. Where they come to rest within
the error, the answer is yes and exit code 0. Where they fall to another shape, no choice of cables
holds them: the answer is no, exit code 3, and what would mend it is tried. docs/feasible.md says
more. tencer design asks the same first.)";

struct FeasibleRequest {
  SceneRequest scene;
  std::filesystem::path output;
  bool json = false;
};

core::Expected<ExitCode> run_feasible(const FeasibleRequest& request, const Console& console) {
  Activity activity(console, "looking whether cables can hold this");
  auto scene = requested_scene(request.scene);
  if (!scene) return scene.error();
  if (!request.output.empty()) {
    if (const auto error = io::folder_problem(request.output)) return *error;
    if (holds_design(request.output))
      return core::Error{request.output.string(),
                         "holds a design, whose picture this would replace; name another folder"};
  }
  if (const auto error = pipeline::scene_problem(*scene)) return *error;
  const Interrupt interrupt;
  introduce(*scene, console);
  const auto found = pipeline::feasible(*scene, {.stop = interrupt.token()});
  if (!found) return found.error();
  if (!request.output.empty() && !found->targets.empty())
    if (const auto error = write_feasibility_files(request.output, *found)) return *error;
  activity.end();
  if (request.json)
    std::cout << io::summary_text(*found);
  else
    console.say(model::report(*found));
  return found->verdict == model::Verdict::can ? ExitCode::ok : ExitCode::tolerance_not_reached;
}

}  // namespace

void add_feasible(CLI::App& app, Command& chosen) {
  CLI::App* command =
      app.add_subcommand("feasible", "Find out whether cables can hold rods in a shape at all");
  command->footer(feasible_examples);
  const auto request = std::make_shared<FeasibleRequest>();
  command->add_option("-o,--output", request->output,
                      "Folder for feasible.json and picture.svg [none]");
  command->add_flag("--json", request->json, "Write JSON instead of words");
  add_scene(*command, request->scene,
            "As a design is asked for a number of cables: it may be further off");
  command->callback([&chosen, request] {
    chosen = [request](const Console& console) { return run_feasible(*request, console); };
  });
}

}  // namespace tencer::app
