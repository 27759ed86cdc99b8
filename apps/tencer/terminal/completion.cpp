#include "terminal/completion.hpp"

#include <functional>
#include <vector>

namespace tencer::app {
namespace {

std::string joined(const std::vector<std::string>& words, const std::string& between = " ") {
  std::string text;
  for (const std::string& word : words) text += (text.empty() ? "" : between) + word;
  return text;
}

// Within single quotes, for any of the shells.
std::string quoted(const std::string& text, const std::string& special = "") {
  std::string result = "'";
  for (const char c : text) {
    if (c == '\'')
      result += "'\\''";
    else
      result += (special.find(c) == std::string::npos ? "" : "\\") + std::string(1, c);
  }
  return result + "'";
}

std::vector<std::string> names_of(const std::vector<CommandEntry>& commands) {
  std::vector<std::string> names;
  for (const CommandEntry& command : commands) names.push_back(command.path.back());
  return names;
}

void for_each(const CommandEntry& command, const std::function<void(const CommandEntry&)>& visit) {
  visit(command);
  for (const CommandEntry& one : command.commands) for_each(one, visit);
}

// Those of the program go with every command.
std::vector<OptionEntry> options_with(const CommandEntry& command, const CommandEntry& program) {
  std::vector<OptionEntry> options = command.options;
  if (!command.path.empty())
    for (const OptionEntry& option : program.options)
      if (option.names.back() != "--help" && option.names.back() != "--version")
        options.push_back(option);
  return options;
}

}  // namespace

std::string bash_completion(const CommandEntry& program) {
  std::string paths;
  std::string values;
  std::string words;
  for_each(program, [&](const CommandEntry& command) {
    const std::string path = joined(command.path);
    if (!path.empty()) paths += (paths.empty() ? "" : "|") + quoted(path);
    std::vector<std::string> offered;
    for (const OptionEntry& option : options_with(command, program)) {
      for (const std::string& name : option.names) {
        offered.push_back(name);
        if (!option.value.empty())
          values += "    " + quoted(path + ' ' + name) +
                    ") choices=" + quoted(joined(option.choices)) + "; value=yes ;;\n";
      }
    }
    std::vector<std::string> arguments = names_of(command.commands);
    for (const OptionEntry& argument : command.arguments)
      arguments.insert(arguments.end(), argument.choices.begin(), argument.choices.end());
    words += "    " + quoted(path) + ") options=" + quoted(joined(offered)) +
             "; arguments=" + quoted(joined(arguments)) + " ;;\n";
  });
  return "# bash completion of tencer, as `tencer completion bash` writes it.\n"
         "_tencer() {\n"
         "  local word path= options= arguments= choices= value=\n"
         "  local now=${COMP_WORDS[COMP_CWORD]} before=${COMP_WORDS[COMP_CWORD-1]}\n"
         "  for word in \"${COMP_WORDS[@]:1:COMP_CWORD-1}\"; do\n"
         "    case \"${path:+$path }$word\" in\n"
         "      " +
         paths +
         ") path=\"${path:+$path }$word\" ;;\n"
         "    esac\n"
         "  done\n"
         "  case \"$path $before\" in\n" +
         values +
         "  esac\n"
         "  case \"$path\" in\n" +
         words +
         "  esac\n"
         "  if [[ -n $value ]]; then\n"
         "    options=$choices\n"
         "  elif [[ $now != -* ]]; then\n"
         "    options=$arguments\n"
         "  fi\n"
         "  COMPREPLY=($(compgen -W \"$options\" -- \"$now\"))\n"
         "}\n"
         "complete -o bashdefault -o default -F _tencer tencer\n";
}

namespace {

std::string zsh_value(const OptionEntry& option) {
  constexpr const char* special = "[]:";
  if (option.value.empty()) return "";
  const std::string name = quoted(option.value, special);
  return "':'" + name + "':'" +
         (option.choices.empty() ? "_files" : quoted("(" + joined(option.choices) + ")"));
}

std::string zsh_option(const OptionEntry& option) {
  std::string names = option.names[0];
  if (option.names.size() > 1)
    names = "'(" + joined(option.names) + ")'{" + joined(option.names, ",") + "}";
  return names + quoted("[" + option.help + "]", "") + zsh_value(option);
}

// A function for each command, its options by _arguments.
std::string zsh_function(const CommandEntry& command, const CommandEntry& program) {
  std::vector<std::string> path = command.path;
  path.insert(path.begin(), "_tencer");
  std::string text = joined(path, "_") + "() {\n";
  const bool has_commands = !command.commands.empty();
  if (has_commands) {
    text += "  local curcontext=$curcontext state line\n  local -a commands=(\n";
    for (const CommandEntry& one : command.commands)
      text += "    " + quoted(one.path.back() + ":" + one.help) + '\n';
    text += "  )\n";
  }
  text += has_commands ? "  _arguments -C" : "  _arguments";
  for (OptionEntry option : options_with(command, program)) {
    std::string help;
    for (const char c : option.help)
      help += (c == '[' || c == ']' || c == ':' || c == '\\' ? "\\" : "") + std::string(1, c);
    option.help = help;
    text += " \\\n    " + zsh_option(option);
  }
  for (const OptionEntry& argument : command.arguments)
    text += " \\\n    '*'" + zsh_value(argument);
  if (!has_commands) return text + "\n}\n";
  text +=
      " \\\n    '1:command:->command' '*::argument:->argument'\n"
      "  case $state in\n"
      "    command) _describe command commands ;;\n"
      "    argument)\n      case $line[1] in\n";
  for (const CommandEntry& one : command.commands)
    text +=
        "        " + one.path.back() + ") " + joined(path, "_") + "_" + one.path.back() + " ;;\n";
  return text + "      esac ;;\n  esac\n}\n";
}

// What is true in fish where the words so far name this command, and none below it.
std::string fish_condition(const CommandEntry& command) {
  if (command.path.empty()) return "__fish_use_subcommand";
  std::string text;
  for (const std::string& word : command.path)
    text += (text.empty() ? "" : "; and ") + ("__fish_seen_subcommand_from " + word);
  if (!command.commands.empty())
    text += "; and not __fish_seen_subcommand_from " + joined(names_of(command.commands));
  return text;
}

std::string fish_option(const OptionEntry& option) {
  std::string text;
  for (const std::string& name : option.names)
    text += name.starts_with("--") ? " -l " + name.substr(2) : " -s " + name.substr(1);
  if (!option.choices.empty())
    text += " -x -a " + quoted(joined(option.choices));
  else if (!option.value.empty())
    text += " -r";
  return text + " -d " + quoted(option.help);
}

}  // namespace

std::string zsh_completion(const CommandEntry& program) {
  std::string text =
      "#compdef tencer\n# zsh completion of tencer, as `tencer completion zsh` writes it.\n";
  for_each(program, [&](const CommandEntry& command) { text += zsh_function(command, program); });
  return text +
         "if [[ $funcstack[1] == _tencer ]]; then\n  _tencer \"$@\"\nelse\n"
         "  compdef _tencer tencer\nfi\n";
}

std::string fish_completion(const CommandEntry& program) {
  std::string text = "# fish completion of tencer, as `tencer completion fish` writes it.\n";
  for_each(program, [&](const CommandEntry& command) {
    const std::string start = "complete -c tencer -n " + quoted(fish_condition(command));
    for (const CommandEntry& one : command.commands)
      text += start + " -f -a " + one.path.back() + " -d " + quoted(one.help) + '\n';
    for (const OptionEntry& argument : command.arguments)
      if (!argument.choices.empty())
        text += start + " -f -a " + quoted(joined(argument.choices)) + '\n';
    for (const OptionEntry& option : command.options) text += start + fish_option(option) + '\n';
  });
  for (const OptionEntry& option : program.options)
    if (option.names.back() != "--help" && option.names.back() != "--version")
      text += "complete -c tencer" + fish_option(option) + '\n';
  return text;
}

}  // namespace tencer::app
