// Scripts that complete the program's command lines in shells.
#pragma once

#include <string>

#include "terminal/command_tree.hpp"

namespace tencer::app {

std::string bash_completion(const CommandEntry& program);
std::string zsh_completion(const CommandEntry& program);
std::string fish_completion(const CommandEntry& program);

}  // namespace tencer::app
