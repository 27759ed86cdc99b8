#include "terminal/command_tree.hpp"

#include <sstream>

namespace tencer::app {
namespace {

// "TEXT:{a4,letter}" holds them.
std::vector<std::string> choices_in(const std::string& type) {
  const std::size_t open = type.find('{');
  const std::size_t close = type.find('}', open);
  std::vector<std::string> choices;
  if (close == std::string::npos) return choices;
  std::istringstream list(type.substr(open + 1, close - open - 1));
  for (std::string choice; std::getline(list, choice, ',');) choices.push_back(choice);
  return choices;
}

OptionEntry entry_of(const CLI::Option& option) {
  OptionEntry entry{.help = option.get_description()};
  if (option.get_positional()) entry.names.push_back(option.get_name(true, false));
  for (const std::string& name : option.get_snames()) entry.names.push_back("-" + name);
  for (const std::string& name : option.get_lnames()) entry.names.push_back("--" + name);
  if (option.get_items_expected_max() == 0) return entry;
  const std::string type = option.get_type_name();
  entry.value = type.substr(0, type.find(':'));
  entry.choices = choices_in(type);
  if (const std::string standard = option.get_default_str(); !standard.empty())
    entry.help += " [" + standard + "]";
  return entry;
}

CommandEntry entry_of(const CLI::App& command, std::vector<std::string> path) {
  CommandEntry entry{
      .path = std::move(path), .help = command.get_description(), .footer = command.get_footer()};
  for (const CLI::Option* option : command.get_options())
    (option->get_positional() ? entry.arguments : entry.options).push_back(entry_of(*option));
  for (const CLI::App* one : command.get_subcommands({})) {
    std::vector<std::string> below = entry.path;
    below.push_back(one->get_name());
    entry.commands.push_back(entry_of(*one, std::move(below)));
  }
  return entry;
}

}  // namespace

CommandEntry command_tree(const CLI::App& app) { return entry_of(app, {}); }

}  // namespace tencer::app
