// tencer completion SHELL, tencer manual: the command line as shells and man know it.
#include <iostream>
#include <memory>
#include <tencer/core/version.hpp>

#include "command.hpp"
#include "terminal/completion.hpp"
#include "terminal/manual.hpp"

namespace tencer::app {
namespace {

constexpr const char* completion_examples = R"(Examples:
  source <(tencer completion bash)           in this shell; in ~/.bashrc, in all of them
  tencer completion bash > ~/.local/share/bash-completion/completions/tencer
  tencer completion zsh > ~/.zfunc/_tencer   a folder of $fpath
  tencer completion fish > ~/.config/fish/completions/tencer.fish

An installed tencer has brought all three.)";

constexpr const char* manual_examples = R"(Examples:
  tencer manual | man -l -                   read it; where tencer is installed: man tencer
  tencer manual > tencer.1)";

}  // namespace

void add_completion(CLI::App& app, Command& chosen) {
  CLI::App* command =
      app.add_subcommand("completion", "Write what completes command lines in a shell");
  command->footer(completion_examples);
  const auto shell = std::make_shared<std::string>();
  command->add_option("SHELL", *shell, "The shell")
      ->required()
      ->check(one_of({"bash", "zsh", "fish"}));
  command->callback([&app, &chosen, shell] {
    chosen = [&app, shell](const Console&) -> core::Expected<ExitCode> {
      const CommandEntry program = command_tree(app);
      std::cout << (*shell == "bash"  ? bash_completion(program)
                    : *shell == "zsh" ? zsh_completion(program)
                                      : fish_completion(program));
      return ExitCode::ok;
    };
  });
}

void add_manual(CLI::App& app, Command& chosen) {
  CLI::App* command = app.add_subcommand("manual", "Write the manual page");
  command->footer(manual_examples);
  command->callback([&app, &chosen] {
    chosen = [&app](const Console&) -> core::Expected<ExitCode> {
      std::cout << manual_page(command_tree(app), "tencer " TENCER_VERSION);
      return ExitCode::ok;
    };
  });
}

}  // namespace tencer::app
