// The stress table, printed group by group as it is worked out.
#pragma once

#include <ostream>

namespace tencer::app::stress {

enum class Format { text, markdown };

// Runs every case; returns how many neither converged nor reported their trouble.
int print_table(std::ostream& out, Format format);

}  // namespace tencer::app::stress
