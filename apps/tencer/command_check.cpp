// tencer check DESIGN: whether a design can be built and does then what it should.
#include <iostream>
#include <memory>
#include <tencer/io/check.hpp>
#include <tencer/pipeline/check.hpp>

#include "command.hpp"
#include "design_files.hpp"
#include "interrupt.hpp"
#include "terminal/activity.hpp"

namespace tencer::app {
namespace {

constexpr const char* check_examples = R"(Examples:
  tencer check knot/design.json                        cables cut to 1 mm and tied to 2 mm
  tencer check knot/design.json --length-error 0.5 --attachment-error 1 --max-deviation 5mm
  tencer check knot/design.json --json                 for programs
  tencer check knot/design.json -o checked             its files, with the check in design.json
  tencer check knot/design.json --repair -o repaired   what moves at no cost is tied

Exit code 3 when something fails, which the report says. docs/check.md has what each line means.)";

struct CheckRequest {
  std::filesystem::path input;
  std::filesystem::path output;
  pipeline::CheckOptions options;
  bool json = false;
  bool force = false;
};

core::Expected<ExitCode> run_check(CheckRequest request, const Console& console) {
  const auto given = io::read_design(request.input);
  if (!given) return given.error();
  if (!request.output.empty())
    if (const auto error = result_problem(request.output, given->name, request.force))
      return *error;
  const Interrupt interrupt;
  Activity activity(console, "checking");
  request.options.stop = interrupt.token();
  const auto checked = pipeline::check(*given, request.options);
  if (!checked) return core::Error{request.input.string(), checked.error().text()};
  if (!request.output.empty()) {
    model::Design design = checked->design;
    design.check = checked->check;
    if (design.complete() && !model::shortfalls(design).empty())
      design.status = model::DesignStatus::tolerance_not_reached;
    if (const auto error = write_design_files(request.output, design)) return *error;
  }
  const model::CheckTerms terms = model::terms_of(checked->design);
  activity.end();
  if (request.json)
    std::cout << io::check_text(checked->design, checked->check);
  else
    console.say(model::report(checked->check, terms));
  if (interrupt.token().stop_requested()) {
    console.log()(core::Level::warning, "interrupted: not everything was looked at");
    return ExitCode::tolerance_not_reached;
  }
  return model::shortfalls(checked->check, terms).empty() ? ExitCode::ok
                                                          : ExitCode::tolerance_not_reached;
}

}  // namespace

void add_check(CLI::App& app, Command& chosen) {
  CLI::App* command = app.add_subcommand("check", "Find out whether a design can be built");
  command->footer(check_examples);
  const auto request = std::make_shared<CheckRequest>();
  pipeline::CheckOptions& options = request->options;
  command->add_option("DESIGN", request->input, "Design (design.json), or a published model")
      ->required();
  command->add_option("--length-error", options.length_error_mm, "Of a cable's length, mm")
      ->check(not_negative_number())
      ->capture_default_str();
  command
      ->add_option("--attachment-error", options.attachment_error_mm,
                   "Of where a cable is tied along a rod, mm")
      ->check(not_negative_number())
      ->capture_default_str();
  command
      ->add_option_function<std::string>(
          "--max-deviation",
          [&options](const std::string& text) {
            options.max_deviation = *model::read_allowance(text);
          },
          "What 95 % of the structures built so may be off by: 5mm, or 1% of the size [1%]")
      ->check(allowance());
  command
      ->add_option("--breaking-load", options.breaking_load_newtons,
                   "Of a cable, N; the default is that of a 1 mm wire rope")
      ->check(positive_number())
      ->capture_default_str();
  command->add_option("--draws", options.draws, "Structures drawn with errors, to first order")
      ->check(positive_integer())
      ->capture_default_str();
  command->add_option("--seed", options.seed, "Of what is drawn")->capture_default_str();
  command->add_flag("--repair", options.repair,
                    "Tie what moves at no cost with the fewest cables, and check that");
  command->add_flag("--json", request->json, "Write JSON instead of words");
  command->add_option("-o,--output", request->output, "Folder for the design with its check");
  add_force(*command, request->force);
  command->callback([&chosen, request] {
    chosen = [request](const Console& console) { return run_check(*request, console); };
  });
}

}  // namespace tencer::app
