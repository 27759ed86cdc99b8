// The commands and options of the program as plain data, from which its manual page and the
// completions of shells are made: the same source as --help.
#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

namespace tencer::app {

struct OptionEntry {
  std::vector<std::string> names{};    // "-o", "--output"; of an argument its one name, "INPUT"
  std::string value{};                 // what follows, "TEXT"; empty: nothing does
  std::vector<std::string> choices{};  // all that may follow; empty: they are not known
  std::string help{};
};

struct CommandEntry {
  std::vector<std::string> path{};  // "target", "circle"; empty: the program itself
  std::string help{};
  std::string footer{};  // examples, and what is to be known
  std::vector<OptionEntry> arguments{};
  std::vector<OptionEntry> options{};
  std::vector<CommandEntry> commands{};
};

CommandEntry command_tree(const CLI::App& app);

}  // namespace tencer::app
