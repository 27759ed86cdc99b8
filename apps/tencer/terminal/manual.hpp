// The manual page.
#pragma once

#include <string>

#include "terminal/command_tree.hpp"

namespace tencer::app {

// For man, in its macros (man(7)).
std::string manual_page(const CommandEntry& program, const std::string& version);

}  // namespace tencer::app
