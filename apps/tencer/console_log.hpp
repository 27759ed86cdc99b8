// The program's log: plain one-line messages on stderr.
#pragma once

#include <tencer/core/log.hpp>

namespace tencer::app {

// Shows messages of this level and above.
core::Log console_log(core::Level least);

}  // namespace tencer::app
