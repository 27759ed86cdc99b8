// A design as the named things that other programs show.
#pragma once

#include <string>
#include <tencer/model/design.hpp>
#include <vector>

namespace tencer::io {

enum class PartKind { rod, cable, anchor };

struct Part {
  PartKind kind = PartKind::rod;
  int index = 0;              // among those of its kind
  std::string name{};         // "rod A", "cable 1", "anchor 1"
  geometry::Polyline line{};  // an anchor's is one point
};

// The rods at their pose, then the cables, then the anchors.
std::vector<Part> parts_of(const model::Design& design);

}  // namespace tencer::io
