// What the sub-commands share. Each is one file command_NAME.cpp with one function add_NAME, which
// declares the command's options and, when the user asked for it, sets `chosen` to its work.
#pragma once

#include <CLI/CLI.hpp>
#include <algorithm>
#include <functional>
#include <optional>
#include <string>
#include <tencer/core/error.hpp>
#include <tencer/model/settings.hpp>
#include <vector>

#include "terminal/console.hpp"

namespace tencer::app {

enum class ExitCode {
  ok = 0,
  unexpected = 1,             // an exception: a fault of the program or of the machine
  bad_input = 2,              // nothing was written
  tolerance_not_reached = 3,  // the result was written and says so
};

// The Error goes to stderr on one line, and the program exits with bad_input.
using Command = std::function<core::Expected<ExitCode>(const Console&)>;

// The check of an option that is a finite number above zero (CLI11's own lets NaN pass).
CLI::Validator positive_number();

// Likewise of a finite number that is not negative.
CLI::Validator not_negative_number();

// Likewise of what model::read_allowance() reads.
CLI::Validator allowance();

// Likewise of a whole number above zero.
CLI::Validator positive_integer();

// Likewise of one of these words.
CLI::Validator one_of(std::vector<std::string> words);

// --force, of a folder for a result.
void add_force(CLI::App& command, bool& force);

// --material, of what rods are made of that say nothing of it.
CLI::Option* add_material(CLI::App& command, std::string& material);

// An option whose values are those of an enumeration, by their names in scene files; `hidden` ones
// are not offered. The help ends with the scene's default.
template <class Enum>
CLI::Option* add_choice(CLI::App& command, const std::string& option, std::optional<Enum>& value,
                        const std::string& help, Enum standard,
                        const std::vector<Enum>& hidden = {}) {
  std::vector<std::string> offered;
  for (const auto& [choice, name] : model::names<Enum>())
    if (std::ranges::find(hidden, choice) == hidden.end()) offered.emplace_back(name);
  return command
      .add_option_function<std::string>(
          option, [&value](const std::string& name) { value = model::named<Enum>(name); },
          help + " [the scene's, else " + std::string(model::name_of(standard)) + "]")
      ->check(one_of(offered));
}

void add_check(CLI::App& app, Command& chosen);
void add_completion(CLI::App& app, Command& chosen);
void add_design(CLI::App& app, Command& chosen);
void add_fabricate(CLI::App& app, Command& chosen);
void add_feasible(CLI::App& app, Command& chosen);
void add_manual(CLI::App& app, Command& chosen);
void add_picture(CLI::App& app, Command& chosen);
void add_simulate(CLI::App& app, Command& chosen);
void add_stress(CLI::App& app, Command& chosen);
void add_study(CLI::App& app, Command& chosen);
void add_target(CLI::App& app, Command& chosen);
void add_view(CLI::App& app, Command& chosen);

}  // namespace tencer::app
