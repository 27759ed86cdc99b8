// tencer rests DESIGN: the other poses that a design rests in, and what keeps it from them.
#include "command_rests.hpp"

#include <iostream>
#include <memory>
#include <tencer/io/file.hpp>
#include <tencer/rehearsal/rests.hpp>

#include "design_in_units.hpp"
#include "interrupt.hpp"
#include "rests/files.hpp"
#include "rests/words.hpp"
#include "terminal/activity.hpp"

namespace tencer::app {
namespace {

constexpr const char* rests_examples = R"(Examples:
  tencer rests knot/design.json                    the poses it rests in, and the ways between them
  tencer rests knot/design.json -o rests           and each as a design, OBJ and picture, and a page
  tencer rests knot/design.json --directions 64    looked for longer
  tencer rests knot/design.json --json             for programs

A finger pushes the design somewhere in some direction, slowly, and lets go: two fingers in opposite
directions where nothing holds it. Where it comes to rest in another pose, that is told, and the pass
between the two is looked for: the least that has to be lifted on the way, and whether strands of
rods pass through each other, so that no hand can take it that way. What is told is what was found:
there may be more poses, and lower passes. With -o the folder gets rests.json, report.txt, for every
pose rest-1.json, rest-1.obj and rest-1.svg, and view.html, which plays the ways.)";

struct RestsRequest {
  std::filesystem::path input;
  std::filesystem::path output;
  motion::RestsOptions options;
  bool json = false;
};

core::Expected<ExitCode> run_rests(RestsRequest request, const Console& console) {
  const auto design = read_design_in_units(request.input);
  if (!design) return design.error();
  if (!request.output.empty())
    if (const auto error = io::folder_problem(request.output)) return *error;
  const Interrupt interrupt;
  Activity activity(console, "pushing");
  request.options.stop = interrupt.token();
  const auto found = rehearsal::rests(*design, request.options);
  if (!found) return core::Error{request.input.string(), found.error().message};
  if (!request.output.empty())
    if (const auto error = io::write_files(request.output, rests_files(*found))) return *error;
  activity.end();
  if (request.json)
    std::cout << rests_json(*found);
  else
    console.say(in_words(*found));
  if (found->finished) return ExitCode::ok;
  console.log()(core::Level::warning, "interrupted: it was not pushed in all directions");
  return ExitCode::tolerance_not_reached;
}

}  // namespace

void add_rests(CLI::App& app, Command& chosen) {
  CLI::App* command = app.add_subcommand("rests", "Find the other poses that a design rests in");
  command->footer(rests_examples);
  const auto request = std::make_shared<RestsRequest>();
  motion::RestsOptions& options = request->options;
  command->add_option("DESIGN", request->input, "Design (design.json), or a published model")
      ->required();
  command->add_option("--directions", options.directions, "In which every pose found is pushed")
      ->check(positive_integer())
      ->capture_default_str();
  command->add_option("--reach", options.reach, "How far a finger moves, of the design's size")
      ->check(positive_number())
      ->capture_default_str();
  command->add_option("--most", options.most_rests, "Poses that are pushed in turn")
      ->check(positive_integer())
      ->capture_default_str();
  command->add_option("--seed", options.seed, "Of what is drawn")->capture_default_str();
  command->add_flag("--json", request->json, "Write JSON instead of words");
  command->add_option("-o,--output", request->output, "Folder for the poses and the ways");
  command->callback([&chosen, request] {
    chosen = [request](const Console& console) { return run_rests(*request, console); };
  });
}

}  // namespace tencer::app
