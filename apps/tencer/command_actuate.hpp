// tencer actuate; see command.hpp.
#pragma once

#include "command.hpp"

namespace tencer::app {

void add_actuate(CLI::App& app, Command& chosen);

}  // namespace tencer::app
