// Words that several texts share.
#pragma once

#include <string>
#include <vector>

namespace tencer::core {

// "1 cable", "2 cables"
inline std::string counted(int count, const std::string& thing) {
  return std::to_string(count) + ' ' + thing + (count == 1 ? "" : "s");
}

// "A", "A and B", "A, B and C"
inline std::string listed(const std::vector<std::string>& things) {
  std::string text;
  for (std::size_t i = 0; i < things.size(); ++i)
    text += (i == 0 ? "" : i + 1 < things.size() ? ", " : " and ") + things[i];
  return text;
}

}  // namespace tencer::core
