// tencer: designs networks of cables that hold bent elastic rods in a chosen shape.
#include <exception>
#include <iostream>
#include <new>
#include <tencer/core/version.hpp>

#include "command.hpp"
#include "command_actuate.hpp"
#include "command_export.hpp"
#include "command_rests.hpp"
#include "terminal/command_line.hpp"

namespace tencer::app {
namespace {

constexpr const char* examples = R"(Examples:
  tencer target torus-knot --p 5 --q 3 -o knot.obj   write a target curve
  tencer feasible knot.obj                           find out whether cables can hold it at all
  tencer design knot.obj -o knot                     design cables that hold a rod in this shape
  tencer simulate knot/design.json                   let the design settle
  tencer check knot/design.json                      find out whether it can be built
  tencer view knot/design.json --open                look at it in the browser
  tencer picture knot/design.json -o knot.pdf        draw it for a paper
  tencer fabricate knot/design.json                  print what is needed to build it
  tencer export knot/design.json -o knot.glb         take it to other programs

Exit codes: 0 done; 1 unexpected failure; 2 bad input or options, nothing written; 3 the tolerance
was not reached, which the result says.)";

// One line, also where CLI11 or a library breaks theirs.
void complain(std::string text) {
  for (char& c : text)
    if (c == '\n') c = ' ';
  std::cerr << "tencer: " << text << '\n';
}

int run(int argc, char** argv) {
  CLI::App app("Hold bent elastic rods in a chosen 3D shape with as few cables as possible.",
               "tencer");
  app.set_version_flag("--version", "tencer " TENCER_VERSION, "Print the version and exit");
  app.set_help_flag("-h,--help", "Print this help and exit");
  app.footer(examples);
  app.require_subcommand(1);
  app.fallthrough();  // inherited by the commands: --quiet may also come after them
  bool quiet = false;
  bool verbose = false;
  app.add_flag("-q,--quiet", quiet, "Say nothing but warnings and errors; the exit code tells");
  app.add_flag("-v,--verbose", verbose, "Say more")->excludes("--quiet");

  Command chosen;
  add_design(app, chosen);
  add_feasible(app, chosen);
  add_simulate(app, chosen);
  add_actuate(app, chosen);
  add_rests(app, chosen);
  add_check(app, chosen);
  add_view(app, chosen);
  add_picture(app, chosen);
  add_fabricate(app, chosen);
  add_export(app, chosen);
  add_target(app, chosen);
  add_stress(app, chosen);
  add_study(app, chosen);
  add_completion(app, chosen);
  add_manual(app, chosen);

  try {
    app.parse(argc, argv);
  } catch (const CLI::Success& asked_for_help) {
    return app.exit(asked_for_help);
  } catch (const CLI::ParseError& error) {
    complain(parse_message(app, error));
    return static_cast<int>(ExitCode::bad_input);
  }
  const core::Level least = verbose ? core::Level::debug
                            : quiet ? core::Level::warning
                                    : core::Level::info;
  const core::Expected<ExitCode> result = chosen(Console(least));
  if (!result) {
    complain(result.error().text());
    return static_cast<int>(ExitCode::bad_input);
  }
  std::cout.flush();
  if (!std::cout) {
    complain("standard output cannot be written");
    return static_cast<int>(ExitCode::unexpected);
  }
  return static_cast<int>(*result);
}

}  // namespace
}  // namespace tencer::app

int main(int argc, char** argv) {
  using namespace tencer::app;
  try {
    return run(argc, argv);
  } catch (const std::bad_alloc&) {
    complain("out of memory");
  } catch (const std::exception& error) {
    complain(std::string("unexpected failure: ") + error.what());
  } catch (...) {
    complain("unexpected failure");
  }
  return static_cast<int>(ExitCode::unexpected);
}
