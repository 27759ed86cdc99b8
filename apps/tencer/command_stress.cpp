// tencer stress: how the solvers fare on stiff, extreme and degenerate cases.
#include <iostream>
#include <memory>
#include <tencer/core/words.hpp>

#include "command.hpp"
#include "stress/table.hpp"

namespace tencer::app {
namespace {

constexpr const char* stress_examples = R"(Examples:
  tencer stress              every case, in a minute or so
  tencer stress --markdown   the same as the tables of docs/stability.md

Each case converges to the digits it promises, or ends in a report that names the trouble. When one
does neither, the exit code is 3.)";

core::Expected<ExitCode> run_stress(stress::Format format, const Console& console) {
  std::ostream nowhere(nullptr);
  const int failed = stress::print_table(console.quiet() ? nowhere : std::cout, format);
  if (failed == 0) return ExitCode::ok;
  console.say('\n' + core::counted(failed, "case") + " FAILED\n");
  return ExitCode::tolerance_not_reached;
}

}  // namespace

void add_stress(CLI::App& app, Command& chosen) {
  CLI::App* command = app.add_subcommand("stress", "Try the solvers on stiff and extreme cases");
  command->footer(stress_examples);
  const auto markdown = std::make_shared<bool>(false);
  command->add_flag("--markdown", *markdown, "Print the tables of docs/stability.md");
  command->callback([&chosen, markdown] {
    chosen = [markdown](const Console& console) {
      return run_stress(*markdown ? stress::Format::markdown : stress::Format::text, console);
    };
  });
}

}  // namespace tencer::app
