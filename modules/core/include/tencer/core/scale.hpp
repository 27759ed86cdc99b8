// The units in which a problem is solved: one length and one energy, so that every tolerance is
// relative and results do not depend on the units of the input.
#pragma once

namespace tencer::core {

// Multiples of the input's units. A quantity in input units divided by its scale is the scaled one.
struct Scale {
  double length = 1.0;
  double energy = 1.0;

  double force() const { return energy / length; }
  double stiffness() const { return energy / (length * length); }  // force per length
  double bending() const { return energy * length; }               // EI, GJ: force times length^2
};

}  // namespace tencer::core
