// Cables for what a design leaves free to move at no cost.
#pragma once

#include <optional>
#include <string>
#include <tencer/model/design.hpp>

#include "check/pose.hpp"

namespace tencer::pipeline {

struct Repaired {
  model::Repair repair{};
  model::Design design{};  // at rest; not set where repair.problem is
};

// The design at rest in `pose` with the fewest cables found that tie its free groups to each other,
// or to anchors and pinned rods. They pull about as its own do, and it stands with them within
// `allowed` (a length of the design) of where it was.
Repaired repair(const RestPose& pose, double allowed, const CheckOptions& options);

}  // namespace tencer::pipeline
