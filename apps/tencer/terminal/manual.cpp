#include "terminal/manual.hpp"

#include <sstream>

namespace tencer::app {
namespace {

// A line of text as roff takes it: nothing in it is a request.
std::string plain(const std::string& line) {
  std::string text;
  for (const char c : line) {
    if (c == '\\')
      text += "\\e";
    else if (c == '-')
      text += "\\-";
    else
      text += c;
  }
  return text.starts_with('.') || text.starts_with('\'') ? "\\&" + text : text;
}

// As it stands: lines that are laid out already.
std::string laid_out(const std::string& lines) {
  std::string text = ".nf\n";
  std::istringstream stream(lines);
  for (std::string line; std::getline(stream, line);) text += plain(line) + '\n';
  return text + ".fi\n";
}

std::string name_of(const CommandEntry& command) {
  std::string name = "tencer";
  for (const std::string& part : command.path) name += ' ' + part;
  return name;
}

std::string usage(const CommandEntry& command) {
  std::string text = ".B " + plain(name_of(command)) + "\n";
  for (const OptionEntry& argument : command.arguments) text += ".I " + argument.names[0] + '\n';
  return text + (command.commands.empty() ? "[\\fIOPTIONS\\fR]\n"
                                          : "[\\fIOPTIONS\\fR] \\fICOMMAND\\fR ...\n");
}

std::string entry(const OptionEntry& option) {
  std::string text = ".TP\n";
  for (const std::string& name : option.names)
    text += (&name == &option.names.front() ? "\\fB" : ", \\fB") + plain(name) + "\\fR";
  std::string choices;
  for (const std::string& choice : option.choices) choices += (choices.empty() ? "" : "|") + choice;
  if (!option.value.empty() && option.names[0].starts_with('-'))
    text += " \\fI" + plain(choices.empty() ? option.value : choices) + "\\fR";
  return text + '\n' + plain(option.help) + '\n';
}

std::string entries(const CommandEntry& command) {
  std::string text;
  for (const OptionEntry& argument : command.arguments) text += entry(argument);
  for (const OptionEntry& option : command.options)
    if (option.names.back() != "--help") text += entry(option);
  return text;
}

// The command and those below it.
std::string sections(const CommandEntry& command) {
  std::string text = ".SS " + plain(name_of(command)) + '\n' + plain(command.help) + ".\n.PP\n" +
                     usage(command) + entries(command);
  if (!command.footer.empty()) text += ".PP\n" + laid_out(command.footer);
  for (const CommandEntry& one : command.commands) text += sections(one);
  return text;
}

}  // namespace

std::string manual_page(const CommandEntry& program, const std::string& version) {
  std::string text = ".TH TENCER 1 \"\" \"" + version + "\" \"User Commands\"\n";
  text += ".SH NAME\ntencer \\- networks of cables that hold bent elastic rods in a shape\n";
  text += ".SH SYNOPSIS\n" + usage(program);
  text += ".SH DESCRIPTION\n" + plain(program.help) + "\n.PP\n" + laid_out(program.footer);
  text += ".SH OPTIONS\nThese go with every command.\n" + entries(program);
  text += ".SH COMMANDS\n";
  for (const CommandEntry& command : program.commands) text += sections(command);
  return text;
}

}  // namespace tencer::app
