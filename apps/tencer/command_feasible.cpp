// tencer feasible INPUT: whether the cables that are allowed can hold a shape at all.
#include <iostream>
#include <memory>
#include <tencer/io/file.hpp>
#include <tencer/pipeline/feasible.hpp>

#include "command.hpp"
#include "design_files.hpp"
#include "interrupt.hpp"
#include "scene_input.hpp"

namespace tencer::app {
namespace {

constexpr const char* examples = R"(Examples:
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
};

core::Expected<ExitCode> run_feasible(const FeasibleRequest& request, const core::Log& log) {
  const auto scene = requested_scene(request.scene);
  if (!scene) return scene.error();
  for (const std::string& note : scene->notes) log(core::Level::info, note);
  if (!request.output.empty())
    if (const auto error = io::folder_problem(request.output)) return *error;
  const Interrupt interrupt;
  const auto found = pipeline::feasible(*scene, {.stop = interrupt.token()});
  if (!found) return found.error();
  if (!request.output.empty() && !found->targets.empty())
    if (const auto error = write_feasibility_files(request.output, *found)) return *error;
  std::cout << model::report(*found);
  return found->verdict == model::Verdict::can ? ExitCode::ok : ExitCode::tolerance_not_reached;
}

}  // namespace

void add_feasible(CLI::App& app, Command& chosen) {
  CLI::App* command =
      app.add_subcommand("feasible", "Find out whether cables can hold rods in a shape at all");
  command->footer(examples);
  const auto request = std::make_shared<FeasibleRequest>();
  command->add_option("-o,--output", request->output,
                      "Folder for feasible.json and picture.svg [none]");
  add_scene(*command, request->scene,
            "As a design is asked for a number of cables: it may be further off");
  command->callback([&chosen, request] {
    chosen = [request](const core::Log& log) { return run_feasible(*request, log); };
  });
}

}  // namespace tencer::app
