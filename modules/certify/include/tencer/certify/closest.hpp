// The least distances in a structure at a pose: what touches or goes through what. Between surfaces
// of rods, round ones or those of a shape's outer fibres, and lines of cables; negative where they
// overlap.
#pragma once

#include <optional>
#include <tencer/model/state.hpp>
#include <vector>

namespace tencer::certify {

// Strands of two rods, or of one that comes back to itself: places whose distance along the rod is
// more than twice that across, which no bend up to a half circle has.
struct RodsApart {
  double distance = 0.0;
  int rod_a = 0;
  double s_a = 0.0;  // arc lengths at rest
  int rod_b = 0;
  double s_b = 0.0;
};

// A cable and a rod, away from the cable's own ends (model/clearance.hpp).
struct CableRodApart {
  double distance = 0.0;
  int cable = 0;
  int rod = 0;
  double s = 0.0;
};

// Two cables that do not meet at a rod or anchor: their ends are six radii apart.
struct CablesApart {
  double distance = 0.0;
  int cable_a = 0;
  int cable_b = 0;
};

// Two places on a rod where cables are tied, along the rod; those at the same place are one.
struct MarksApart {
  double distance = 0.0;
  int rod = 0;
  double s_a = 0.0;
  double s_b = 0.0;
};

// Not set: there is no such pair.
struct Closest {
  std::optional<RodsApart> rods{};
  std::optional<CableRodApart> cable_rod{};
  std::optional<CablesApart> cables{};
  std::optional<MarksApart> marks{};
};

// Of each pair of rods, and of a rod and itself, the nearest such places, in order of the rods.
std::vector<RodsApart> closest_rods(const model::Structure& structure, const model::State& state);

Closest closest(const model::Structure& structure, const model::State& state);

}  // namespace tencer::certify
