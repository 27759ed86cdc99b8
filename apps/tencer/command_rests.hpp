// tencer rests; see command.hpp.
#pragma once

#include "command.hpp"

namespace tencer::app {

void add_rests(CLI::App& app, Command& chosen);

}  // namespace tencer::app
