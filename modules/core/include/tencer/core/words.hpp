// Words that several texts share.
#pragma once

#include <string>

namespace tencer::core {

// "1 cable", "2 cables"
inline std::string counted(int count, const std::string& thing) {
  return std::to_string(count) + ' ' + thing + (count == 1 ? "" : "s");
}

}  // namespace tencer::core
