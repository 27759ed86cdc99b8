// Numbers as they are printed on a sheet.
#pragma once

#include <string>

namespace tencer::app {

// With three significant digits, as in view.html: "0.0123", "12.3", "12300".
std::string significant(double value);

}  // namespace tencer::app
