// What is known before a search: whether the cables that a scene allows can hold its shape at all,
// and if not, a motion that proves it and what would mend it. Plain data in the scene's units.
#pragma once

#include <string>
#include <tencer/geometry/polyline.hpp>
#include <tencer/model/at_least.hpp>
#include <vector>

namespace tencer::model {

enum class Verdict {
  can,      // the rods rest within the error that is asked for, all cables tied
  unclear,  // they rest further away, by so little that other lengths may bring them back
  cannot    // they fall to another shape, and no cable that is allowed keeps them from it
};

// Something else that was tried in place of what the scene says.
struct Mend {
  std::string change{};  // "cables to a frame about the rods: frame = {shape = \"cube\"}"
  bool helps = false;    // the rods then rest within the error
  double percent = 0.0;  // how far they rest from the target that they then have
};

struct Feasibility {
  std::string name{};
  std::string length_unit{};
  Verdict verdict = Verdict::can;
  double max_error = 0.0;  // that was asked for, % of the target's bounding-box diagonal
  int vertices = 0;        // of the rods as they were looked at
  int cables = 0;          // that the rules allow between these vertices
  // Let go with all of them tied at the target's lengths.
  double percent = 0.0;      // where the rods rest: the largest distance from the target
  bool rests = false;        // false: there they were still moving
  double released = 0.0;     // part of their energy that the rods have lost on the way
  double lengthening = 0.0;  // of the cable that is longer there by most, relative
  // Rods that every cable to the others draws to these, with no way to keep them apart; empty: none
  // are. The motions are then these rods' towards the others, a tenth of the target's size.
  std::vector<int> apart{};
  // To first order, at the target: the dual of the balance of forces.
  double unbalanced = 0.0;  // how far the forces that no tensions balance move the rods, %
  double power = 0.0;       // energy that the rods lose by that motion, of that at the target
  AtLeast at_least{};       // within the error, of the scene's own vertices
  // The targets as they were looked at, and how each vertex moves (3 x n) to where the rods rest.
  std::vector<geometry::Polyline> targets{};
  std::vector<Eigen::Matrix3Xd> motions{};
  std::vector<std::string> warnings{};  // corners, noise, strains, touching rods, with places
  std::vector<Mend> mends{};
  double seconds = 0.0;
};

// The verdict in a line, without its end.
std::string summary(const Feasibility& feasibility);

// That and the rest in words, a line each.
std::string report(const Feasibility& feasibility);

// One sentence: why it cannot be, and what would mend it.
std::string reason(const Feasibility& feasibility);

}  // namespace tencer::model
