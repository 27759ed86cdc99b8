// Words that several texts share.
#pragma once

#include <string>

namespace tencer::model {

inline std::string counted(int count, const std::string& thing) {
  return std::to_string(count) + ' ' + thing + (count == 1 ? "" : "s");
}

}  // namespace tencer::model
