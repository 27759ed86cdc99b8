// Which cables a design may have.
#pragma once

#include <limits>
#include <optional>
#include <tencer/model/structure.hpp>
#include <vector>

namespace tencer::model {

inline constexpr double unwanted_part = 0.05;

struct RodPair {
  int a = 0;
  int b = 0;  // may be the same rod
};

// A part of a rod between two arc lengths at rest, ends included; from == to is one place. On a
// closed rod an arc with to < from runs across the seam.
struct Arc {
  int rod = 0;
  double from = 0.0;
  double to = 0.0;
};

// What keeps clear of what. Lengths are in the structure's units.
struct Gaps {
  // Between a cable's line and a rod's surface; not set: the rod's outer radius.
  std::optional<double> clearance{};
  // Between the marks of two cables on a rod, unless they are the same; not set: four outer radii.
  std::optional<double> mark_distance{};
  // To either side of its own end a cable may be as near its rod as it likes for so many outer
  // radii, and no more than a quarter of the way to its other end: it has left the rod by then.
  double own_radii = 6.0;

  double from_axis(double radius) const { return radius + clearance.value_or(radius); }
  double between_marks(double radius) const { return mark_distance.value_or(4 * radius); }

  // Throws std::invalid_argument, naming the field, for a negative number.
  void validate() const;
};

// Lengths are in the structure's units.
struct Rules {
  std::optional<std::vector<RodPair>> pairs{};  // rods that cables may join; not set: any
  std::vector<Arc> forbidden{};                 // where no cable may attach
  double max_cable_length = std::numeric_limits<double>::infinity();
  bool external = true;  // cables to anchors, when the structure has any
  // None whose both ends are within `unwanted_part` of a rod's length of the ends of one of these;
  // of an anchor, the same one. Only their ends count.
  std::vector<springs::Cable> unwanted{};
  std::optional<Gaps> gaps{};  // what keeps clear of what; not set: cables may pass through rods
};

// Throws std::invalid_argument, naming the field, unless rods exist, arcs lie on their rod and
// max_cable_length is positive.
void validate(const Rules& rules, const Structure& structure);

// Whether cables may join two rods.
bool pair_allowed(const Rules& rules, int rod_a, int rod_b);

// Whether a cable may attach at arc length s of a rod (any s on a closed rod).
bool place_allowed(const Rules& rules, const Structure& structure, int rod, double s);

// Whether a cable is like one of the unwanted ones.
bool is_unwanted(const Rules& rules, const std::vector<geometry::ArcLength>& along,
                 const springs::Cable& cable);

struct Interval {
  double lower = 0.0;
  double upper = 0.0;
};

// How far a cable end may slide from an allowed place s without leaving its rod or entering a
// forbidden arc; the bounds are allowed places. On a closed rod without forbidden arcs: one length
// of the rod either way.
Interval sliding_interval(const Rules& rules, const Structure& structure, int rod, double s);

}  // namespace tencer::model
