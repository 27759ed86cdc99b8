// What to cut and where to mark it: every rod with its marks, every cable with its knots. Lengths
// are in mm, forces in N, masses in kg, whatever the design's units.
#pragma once

#include <optional>
#include <tencer/model/clearance.hpp>
#include <tencer/model/design.hpp>
#include <vector>

namespace tencer::fabricate {

// What a piece is longer than what it is needed for. Not negative.
struct Allowances {
  // By how much the two ends of a closed rod overlap where they are joined; 0: they meet, in a
  // sleeve.
  double joint = 0.0;
  // Of a cable, at either end, beyond the place where it touches the rod or anchor: what goes round
  // it and into the knot.
  double knot = 60.0;
};

// Marks are along the centre line at rest, from the rod's start: vertex 0 of the design. A closed
// rod is joined there, unless a mark is nearer to it than 30 mm or the overlap: then in the middle
// between the two marks, one after the other, that are farthest apart.
struct RodCut {
  bool closed = false;
  double length = 0.0;
  double cut = 0.0;  // length, and on a closed rod the joint
  double radius = 0.0;
  double joint = 0.0;                    // along the rod; 0 of an open one
  std::vector<model::Mark> marks{};      // from the joint on
  std::optional<double> nearest_mark{};  // from the joint, either way round; not set: no joint
  std::optional<double> mass{};          // of the piece; not set: not known

  // How far from the end of the piece, which begins at the joint, a place along the rod is.
  double from_end(double s) const { return s < joint ? s - joint + length : s - joint; }
};

struct CableCut {
  springs::End a{};
  springs::End b{};
  double between_centres = 0.0;  // of rods; an anchor is a point. The design's own length
  double between_knots = 0.0;    // from surface to surface: less the radii of the rods at its ends
  double cut = 0.0;              // between the knots, and what both take
  double tension = 0.0;
};

struct CutList {
  Allowances allowances{};
  std::vector<RodCut> rods{};
  std::vector<CableCut> cables{};

  double rods_cut() const;    // altogether
  double cables_cut() const;  // altogether
  std::optional<double> rods_mass() const;
};

// Throws std::invalid_argument for a unit that is none of units.hpp, and for allowances that are
// negative or not finite.
CutList cut_list(const model::Design& design, const Allowances& allowances = {});

}  // namespace tencer::fabricate
