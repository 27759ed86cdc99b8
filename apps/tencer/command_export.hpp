// tencer export; see command.hpp.
#pragma once

#include "command.hpp"

namespace tencer::app {

void add_export(CLI::App& app, Command& chosen);

}  // namespace tencer::app
