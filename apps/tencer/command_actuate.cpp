// tencer actuate DESIGN SCHEDULE: what a design does when its cables are pulled and let go.
#include "command_actuate.hpp"

#include <memory>
#include <tencer/io/file.hpp>
#include <tencer/io/schedule.hpp>
#include <tencer/rehearsal/actuate.hpp>

#include "actuate/actuate.hpp"
#include "actuate/words.hpp"
#include "design_in_units.hpp"
#include "interrupt.hpp"
#include "terminal/activity.hpp"

namespace tencer::app {
namespace {

constexpr const char* actuate_examples = R"(Examples:
  tencer actuate gripper/design.json grip.toml             what happens, in words
  tencer actuate gripper/design.json grip.toml -o moves    and every pose, as a page, OBJ and CSV

The schedule is TOML. Cables go by the numbers that they have on the sheet and on the page:

  [[step]]                  # pulled in
  2 = "by -12 mm"
  5-7 = "to 80 %"           # of their lengths in the design
  frames = 20               # poses on the way; 10 by default

  [[step]]                  # and let go again
  all = "to 100 %"

Cables of a step change length together, slowly, and neither stretch nor push. Where poses end or
become unstable, the structure snaps: both poses and the energy that it releases are told. Strands
that overlap on the way are told too, but do not hold each other. With -o the folder gets poses.csv,
pose-0000.obj and so on, start.svg, end.svg, report.txt and view.html, which plays them. The exit
code is 3 when no rest is found before the end.)";

struct ActuateRequest {
  std::filesystem::path input;
  std::filesystem::path schedule;
  std::filesystem::path output;
};

core::Expected<ExitCode> run_actuate(const ActuateRequest& request, const Console& console) {
  const auto design = read_design_in_units(request.input);
  if (!design) return design.error();
  const auto schedule = io::read_schedule(request.schedule, *design);
  if (!schedule) return schedule.error();
  if (!request.output.empty())
    if (const auto error = io::folder_problem(request.output)) return *error;
  const Interrupt interrupt;
  Activity activity(console, "pulling cables");
  const auto actuated = rehearsal::actuate(*design, *schedule, interrupt.token());
  if (!actuated) return core::Error{request.input.string(), actuated.error().message};
  if (!request.output.empty())
    if (const auto error = io::write_files(request.output, actuation_files(*actuated)))
      return *error;
  activity.end();
  console.say(in_words(*actuated));
  return actuated->finished ? ExitCode::ok : ExitCode::tolerance_not_reached;
}

}  // namespace

void add_actuate(CLI::App& app, Command& chosen) {
  CLI::App* command = app.add_subcommand("actuate", "Pull cables, and see what the design does");
  command->footer(actuate_examples);
  const auto request = std::make_shared<ActuateRequest>();
  command->add_option("DESIGN", request->input, "Design (design.json), or a published model")
      ->required();
  command->add_option("SCHEDULE", request->schedule, "What becomes of which cable's length (TOML)")
      ->required();
  command->add_option("-o,--output", request->output, "Folder for the poses");
  command->callback([&chosen, request] {
    chosen = [request](const Console& console) { return run_actuate(*request, console); };
  });
}

}  // namespace tencer::app
