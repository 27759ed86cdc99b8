#include "terminal/command_line.hpp"

#include <optional>
#include <string_view>
#include <tencer/core/nearest.hpp>
#include <tencer/core/words.hpp>
#include <vector>

namespace tencer::app {
namespace {

std::vector<std::string> commands_of(const CLI::App& command) {
  std::vector<std::string> names;
  for (const CLI::App* one : command.get_subcommands({})) names.push_back(one->get_name());
  return names;
}

// Long ones, without their dashes, with those that the commands above pass on.
std::vector<std::string> options_of(const CLI::App& command) {
  std::vector<std::string> names;
  for (const CLI::App* at = &command; at; at = at->get_parent())
    for (const CLI::Option* option : at->get_options())
      for (const std::string& name : option->get_lnames()) names.push_back(name);
  return names;
}

// "--closd", and what it may mean.
std::string suggested(const std::string& word, const std::vector<std::string>& known) {
  const std::vector<std::string_view> views(known.begin(), known.end());
  std::string name = word.substr(0, word.find('='));
  name.erase(0, name.find_first_not_of('-'));
  const std::string_view meant = core::nearest(name, views);
  return word + (meant.empty() ? "" : " (did you mean --" + std::string(meant) + "?)");
}

bool is_option(const std::string& word) {
  return word.size() > 1 && word[0] == '-' && word != "--" &&
         word.find_first_of("0123456789.") != 1;
}

std::optional<std::string> unknown_options(const CLI::App& command,
                                           const std::vector<std::string>& unread) {
  std::vector<std::string> unknown;
  for (const std::string& word : unread)
    if (is_option(word)) unknown.push_back(suggested(word, options_of(command)));
  if (unknown.empty()) return std::nullopt;
  return "there is no option " + core::listed(unknown);
}

std::string unknown_command(const CLI::App& command, const std::string& word) {
  const std::vector<std::string> known = commands_of(command);
  const std::vector<std::string_view> views(known.begin(), known.end());
  const std::string_view meant = core::nearest(word, views);
  const std::string text = "there is no '" + word + "' here; ";
  if (!meant.empty()) return text + "did you mean " + std::string(meant) + "?";
  return text + "use one of " + core::listed(known);
}

std::string one_too_many(const std::vector<std::string>& unread) {
  return "'" + core::listed(unread) + "' is too much: " +
         (unread.size() == 1 ? "nothing that is asked for takes it"
                             : "nothing that is asked for takes them");
}

}  // namespace

std::string parse_message(const CLI::App& app, const CLI::ParseError& error) {
  std::string help = "tencer";
  const CLI::App* command = &app;
  while (!command->get_subcommands().empty()) {
    command = command->get_subcommands().front();
    help += " " + command->get_name();
  }
  const std::string end = " (see " + help + " --help)";
  const std::vector<std::string> unread = app.remaining(true);
  const std::vector<std::string> known = commands_of(*command);
  if (!known.empty() && !unread.empty() && !is_option(unread.front()))
    return unknown_command(*command, unread.front()) + end;
  if (const auto unknown = unknown_options(*command, unread)) return *unknown + end;
  if (!known.empty() && dynamic_cast<const CLI::RequiredError*>(&error))
    return "a command is missing; use one of " + core::listed(known) + end;
  if (!unread.empty()) return one_too_many(unread) + end;
  std::string message = error.what();
  if (dynamic_cast<const CLI::ArgumentMismatch*>(&error) && message.ends_with(" missing"))
    message = message.substr(0, message.find(':')) + ": its value is missing";
  return message + end;
}

}  // namespace tencer::app
