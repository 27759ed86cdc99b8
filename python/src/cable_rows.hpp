// Cables as rows of a structured array.
#pragma once

#include <tencer/springs/cable.hpp>
#include <vector>

#include "arrays.hpp"

namespace tencer::python {

// An end is on a rod at arc length s, or at an anchor, and the other is -1.
struct CableRow {
  int rod_a = -1, anchor_a = -1;
  double s_a = 0.0;
  int rod_b = -1, anchor_b = -1;
  double s_b = 0.0;
  double length = 0.0, tension = 0.0, stiffness = 0.0, rest_length = 0.0;
};

inline constexpr const char* cable_columns =
    "rod_a, s_a (arc length at rest) or anchor_a, the others -1; likewise b; length and tension as "
    "built; stiffness and rest_length as a spring, 0 if it is none.";

CableRow row_of(const springs::Cable& cable, double length, double tension);

}  // namespace tencer::python
