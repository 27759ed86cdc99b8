// What the sub-commands share. Each is one file command_NAME.cpp with one function add_NAME, which
// declares the command's options and, when the user asked for it, sets `chosen` to its work.
#pragma once

#include <CLI/CLI.hpp>
#include <functional>
#include <tencer/core/error.hpp>
#include <tencer/core/log.hpp>

namespace tencer::app {

enum class ExitCode {
  ok = 0,
  unexpected = 1,             // an exception: a fault of the program or of the machine
  bad_input = 2,              // nothing was written
  tolerance_not_reached = 3,  // the result was written and says so
};

// The Error goes to stderr on one line, and the program exits with bad_input.
using Command = std::function<core::Expected<ExitCode>(const core::Log&)>;

// The check of an option that is a finite number above zero (CLI11's own lets NaN pass).
CLI::Validator positive_number();

// Likewise of a whole number.
CLI::Validator positive_integer();

void add_design(CLI::App& app, Command& chosen);
void add_simulate(CLI::App& app, Command& chosen);
void add_stress(CLI::App& app, Command& chosen);
void add_study(CLI::App& app, Command& chosen);
void add_target(CLI::App& app, Command& chosen);

}  // namespace tencer::app
