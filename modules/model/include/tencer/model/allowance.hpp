// How far something may be off: a length, or a part of the target's size.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace tencer::model {

struct Allowance {
  double amount = 1.0;
  std::string unit = "%";  // of the target's bounding-box diagonal, or one of length_units()

  // What is wrong, to follow a name; not set: nothing.
  std::optional<std::string> problem() const;

  // In a unit of length (std::invalid_argument for another than those of units.hpp, unless this is
  // in %). size: the diagonal, in the same unit.
  double length(std::string_view length_unit, double size) const;
};

// "2 mm", "2mm", "0.5 %", or a number alone, in %. Not set: it is none of these, or not positive.
std::optional<Allowance> read_allowance(std::string_view text);

}  // namespace tencer::model
