// Numbers for readers.
#pragma once

#include <string>

namespace tencer::model {

// With as many digits as a tape measure gives: at least so many, and none before the point left
// out.
std::string with_digits(double value, int digits);

}  // namespace tencer::model
