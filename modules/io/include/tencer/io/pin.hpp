// A rod's vertex held in space.
#pragma once

#include <array>

namespace tencer::io {

// The coordinates x, y, z of the vertex marked true keep their target values.
struct Pin {
  int rod = 0;
  int vertex = 0;
  std::array<bool, 3> axes{true, true, true};
};

}  // namespace tencer::io
