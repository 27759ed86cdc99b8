// What may vary of the cables of a structure.
#pragma once

namespace tencer::springs {

// position_a, position_b: the arc length s at which end a or b is attached to its rod.
enum class ParameterKind { stiffness, rest_length, position_a, position_b };

struct Parameter {
  ParameterKind kind = ParameterKind::stiffness;
  int cable = 0;
};

}  // namespace tencer::springs
